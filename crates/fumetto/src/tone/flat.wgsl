// Light to flat colour: the diffuse term of every light through the object's ramp (McGuire & Fein 2004,
// section 1.2).

// Whether any pixel may show a triangle.
override HAS_MESHES: bool = false;

// Whether this paints straight into the picture, where nothing is half transparent.
override IS_PICTURE: bool = false;

struct Sampling {
    // Pixels of the picture to one texel of the normal layer.
    step: i32,
}

@group(0) @binding(1) var<uniform> sampling: Sampling;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var<storage, read> puffs: array<Puff>;
@group(0) @binding(4) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(5) var id_layer: texture_2d<u32>;
@group(0) @binding(6) var depth_layer: texture_depth_2d;
@group(0) @binding(7) var normals: texture_2d<f32>;
@group(0) @binding(8) var shadows: texture_2d<f32>;
@group(0) @binding(9) var ramps: texture_2d<f32>;
@group(0) @binding(10) var linear: sampler;
@group(0) @binding(11) var<storage, read> sources: array<Source>;
@group(0) @binding(12) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(13) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(14) var<storage, read> parts: array<Part>;
@group(0) @binding(15) var textures: texture_2d_array<f32>;
@group(0) @binding(16) var textures_sampler: sampler;

// The normal between the layer's texels, from those that lie about as deep.
fn normal_at(px: vec2i, distance: f32) -> vec3f {
    if sampling.step == 1 {
        return textureLoad(normals, px, 0).xyz;
    }
    let at = vec2f(px) / f32(sampling.step);
    let cell = vec2i(floor(at));
    let part = at - floor(at);
    let last = vec2i(textureDimensions(normals)) - 1;
    var normal = vec3f(0.0);
    for (var corner = 0; corner < 4; corner++) {
        let step = vec2i(corner & 1, corner >> 1);
        let texel = textureLoad(normals, min(cell + step, last), 0);
        let bilinear = select(1.0 - part, part, step == vec2i(1));
        // Texels elsewhere in depth count for almost nothing, unless there are no others.
        let apart = abs(texel.w - log2(distance)) * 64.0;
        normal += texel.xyz * ((bilinear.x * bilinear.y + 1e-3) / (1.0 + apart * apart * apart * apart));
    }
    return normal;
}

// What a pixel shows.
struct Seen {
    object: u32,
    opacity: f32,
    normal: vec3f,
    // What tones are multiplied by; linear.
    colour: vec3f,
}

fn seen_at(id: u32, px: vec2i, distance: f32) -> Seen {
    if HAS_MESHES && (id & TRIANGLE_BIT) != 0u {
        let surface = mesh_surface(id & ~TRIANGLE_BIT, vec2f(px) + 0.5);
        let object = parts[surface.part].object;
        return Seen(object, 1.0, surface.normal, mix(vec3f(1.0), surface.colour.rgb, styles[object].material));
    }
    let puff = puffs[id - 1u];
    let normal = normal_at(px, distance);
    return Seen(puff_object(puff), puff_fade(puff).y, normal / max(length(normal), 1e-6), vec3f(1.0));
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let px = vec2i(position.xy);
    let id = textureLoad(id_layer, px, 0).x;
    if id == 0u {
        discard;
    }
    let distance = distance_of(textureLoad(depth_layer, px, 0));
    let seen = seen_at(id, px, distance);
    let style = styles[seen.object];
    let place = (view.world_from_view * vec4f(ray_of(position.xy) * distance, 1.0)).xyz;
    let shadow = textureSampleLevel(shadows, linear, position.xy / view.size_px, 0.0);
    var amount = 0.0;
    for (var i = 0u; i < lights.count; i++) {
        let light = lights.light[i];
        let kept = light.channel >= 0 && shadow[max(light.channel, 0)] >= 0.5;
        amount += select(diffuse(light, seen.normal, toward(light, place), style.wrap), 0.0, kept);
    }
    var colour = ramp_colour(ramps, amount, style.ramp_row);
    // White leaves a picked tone exactly as it is.
    if HAS_MESHES && any(abs(seen.colour - 1.0) > vec3f(1e-3)) {
        colour = encoded(decoded(colour) * seen.colour);
    }
    return vec4f(colour, select(style.opacity * seen.opacity, 1.0, IS_PICTURE));
}
