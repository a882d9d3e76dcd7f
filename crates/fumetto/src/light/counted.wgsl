// Adds the shadows that were counted for one light to those that are known.

struct Counted {
    // 1 in the light's channel.
    channel: vec4f,
}

@group(0) @binding(0) var<uniform> counted: Counted;
@group(0) @binding(1) var counts: texture_2d<f32>;
@group(0) @binding(2) var known: texture_2d<f32>;
@group(0) @binding(3) var linear: sampler;
@group(0) @binding(4) var id_layer: texture_2d<u32>;
@group(0) @binding(5) var<storage, read> facings: array<u32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let px = vec2i(position.xy);
    let at = position.xy / vec2f(textureDimensions(counts));
    let shadow = select(vec4f(0.0), vec4f(1.0), textureSampleLevel(known, linear, at, 0.0) >= vec4f(0.5));
    let id = textureLoad(id_layer, px, 0).x;
    let number = id & ~TRIANGLE_BIT;
    var facing = 0u;
    if id != number && number < arrayLength(&facings) {
        facing = facings[number];
    }
    let is_counted = abs(textureLoad(counts, px, 0).x) >= 0.5 && (facing & AT_TERMINATOR) == 0u;
    if is_counted || (facing & IN_VALLEY) != 0u {
        return max(shadow, counted.channel);
    }
    return shadow;
}
