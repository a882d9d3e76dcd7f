// Light to flat colour: the diffuse term of every light through the object's ramp (McGuire & Fein 2004,
// section 1.2).

// Whether any pixel may show a triangle.
override HAS_MESHES: bool = false;

// Whether this paints straight into the picture, where nothing is half transparent.
override IS_PICTURE: bool = false;

// Whether any object's style asks for these.
override HAS_ROWS: bool = false;
override HAS_GOOCH: bool = false;
override HAS_HIGHLIGHT: bool = false;
override HAS_RIM: bool = false;
override HAS_EXAGGERATION: bool = false;
override HAS_STEPS: bool = false;

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
@group(0) @binding(17) var<storage, read> smoothed: array<u32>;
@group(0) @binding(18) var<uniform> tones: array<ToneStyle, MAX_OBJECTS>;

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
    // Unit length.
    normal: vec3f,
    // What tones are multiplied by; linear.
    colour: vec3f,
    // Of a triangle: its corners' numbers and weights, its part, and the side that is seen, 1 or -1. Of a
    // puff: 0.
    corners: vec3u,
    weights: vec3f,
    part: u32,
    side: f32,
    // Of a puff, in metres.
    radius: f32,
}

fn seen_at(id: u32, px: vec2i, distance: f32) -> Seen {
    var seen: Seen;
    if HAS_MESHES && (id & TRIANGLE_BIT) != 0u {
        let surface = mesh_surface(id & ~TRIANGLE_BIT, vec2f(px) + 0.5);
        seen.object = parts[surface.part].object;
        seen.opacity = 1.0;
        seen.normal = surface.normal;
        seen.colour = mix(vec3f(1.0), own_colour(surface.colour.rgb, seen.object), styles[seen.object].material);
        seen.corners = surface.corners;
        seen.weights = surface.weights;
        seen.part = surface.part;
        seen.side = surface.side;
        return seen;
    }
    let puff = puffs[id - 1u];
    let normal = normal_at(px, distance);
    seen.object = puff_object(puff);
    seen.opacity = puff_fade(puff).y;
    seen.normal = normal / max(length(normal), 1e-6);
    seen.colour = vec3f(1.0);
    seen.radius = puff.radius;
    return seen;
}

// A mesh's own colour, as its style takes it.
fn own_colour(linear: vec3f, object: u32) -> vec3f {
    if HAS_STEPS && tones[object].material_steps > 0.0 {
        return quantised(linear, tones[object].material_steps);
    }
    return linear;
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
    let toward_eye = normalize(view.world_from_view[3].xyz - place);
    let wrap = select(style.wrap, 1.0, HAS_GOOCH && tones[seen.object].is_gooch != 0u);
    var amount = 0.0;
    var shine = 0.0;
    for (var i = 0u; i < lights.count; i++) {
        let light = lights.light[i];
        if light.channel >= 0 && shadow[max(light.channel, 0)] >= 0.5 {
            continue;
        }
        let toward_light = toward(light, place);
        var here = diffuse(light, seen.normal, toward_light, wrap);
        if HAS_EXAGGERATION && i == 0u && tones[seen.object].exaggerate_amount > 0.0 {
            let relief = light.intensity * exaggerated(seen, position.xy, distance, toward_light, tones[seen.object]);
            here = mix(here, relief, tones[seen.object].exaggerate_amount);
        }
        amount += here;
        if HAS_HIGHLIGHT {
            shine = max(shine, blinn_phong(light, seen.normal, toward_light, toward_eye, tones[seen.object].gloss));
        }
    }
    let facing = max(dot(seen.normal, toward_eye), 0.0);
    let colour = colour_of(seen, amount, shine, facing, Sight(place, distance));
    return vec4f(colour, select(style.opacity * seen.opacity, 1.0, IS_PICTURE));
}

// Where a pixel is.
struct Sight {
    place: vec3f,
    distance: f32,
}

// The colour of an amount of light, encoded; `shine` is the highlight's term, and `facing` the cosine between
// surface and viewer.
fn colour_of(seen: Seen, amount: f32, shine: f32, facing: f32, at: Sight) -> vec3f {
    if HAS_HIGHLIGHT && shine >= tones[seen.object].highlight_from {
        return tones[seen.object].highlight_colour;
    }
    if HAS_RIM && facing < tones[seen.object].rim_width && amount >= tones[seen.object].rim_from {
        return tones[seen.object].rim_colour;
    }
    if HAS_GOOCH && tones[seen.object].is_gooch != 0u {
        return cool_to_warm(tones[seen.object], seen.colour, amount);
    }
    var row = styles[seen.object].ramp_row;
    if HAS_ROWS && tones[seen.object].axis != AXIS_NONE {
        row = row_of(tones[seen.object], facing, at.place, at.distance);
    }
    let colour = ramp_colour(ramps, amount, row);
    // White leaves a picked tone exactly as it is.
    if HAS_MESHES && any(abs(seen.colour - 1.0) > vec3f(1e-3)) {
        return encoded(decoded(colour) * seen.colour);
    }
    return colour;
}
