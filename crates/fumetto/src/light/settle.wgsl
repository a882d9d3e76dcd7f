// Averages the shadow mask along one axis: the shadow's edge, found where the average is one half, is a
// smooth curve, and specks and slivers are gone.

struct Settle {
    axis: vec2i,
    // In texels.
    radius: i32,
}

@group(0) @binding(0) var<uniform> settle: Settle;
@group(0) @binding(1) var mask: texture_2d<f32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let at = vec2i(position.xy);
    let last = vec2i(textureDimensions(mask)) - 1;
    var sum = vec4f(0.0);
    for (var step = -settle.radius; step <= settle.radius; step++) {
        sum += textureLoad(mask, clamp(at + settle.axis * step, vec2i(0), last), 0);
    }
    return sum / f32(2 * settle.radius + 1);
}
