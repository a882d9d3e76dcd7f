// Light to flat colour: the diffuse term of every light through the object's ramp (McGuire & Fein 2004,
// section 1.2).

struct Sampling {
    // Pixels of the picture to one texel of the normal layer.
    step: i32,
}

@group(0) @binding(1) var<uniform> sampling: Sampling;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var<storage, read> puffs: array<Puff>;
@group(0) @binding(4) var<storage, read> styles: array<ObjectStyle>;
@group(0) @binding(5) var id_layer: texture_2d<u32>;
@group(0) @binding(6) var depth_layer: texture_depth_2d;
@group(0) @binding(7) var normals: texture_2d<f32>;
@group(0) @binding(8) var shadows: texture_2d<f32>;
@group(0) @binding(9) var ramps: texture_2d<f32>;
@group(0) @binding(10) var linear: sampler;

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

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let px = vec2i(position.xy);
    let id = textureLoad(id_layer, px, 0).x;
    if id == 0u {
        discard;
    }
    let puff = puffs[id - 1u];
    let style = styles[puff_object(puff)];
    let distance = distance_of(textureLoad(depth_layer, px, 0));
    let place = (view.world_from_view * vec4f(ray_of(position.xy) * distance, 1.0)).xyz;
    let unscaled = normal_at(px, distance);
    let normal = unscaled / max(length(unscaled), 1e-6);
    let shadow = textureSampleLevel(shadows, linear, position.xy / view.size_px, 0.0);
    var amount = 0.0;
    for (var i = 0u; i < lights.count; i++) {
        let light = lights.light[i];
        let kept = light.channel >= 0 && shadow[max(light.channel, 0)] >= 0.5;
        amount += select(diffuse(light, normal, toward(light, place), style.wrap), 0.0, kept);
    }
    return vec4f(ramp_colour(ramps, amount, style.ramp_row), style.opacity * puff_fade(puff).y);
}
