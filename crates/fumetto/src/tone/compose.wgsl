// Lays a cel with its ink over what is there, and averages the samples of each pixel in linear light.

@group(0) @binding(0) var<uniform> compose: Compose;
@group(0) @binding(1) var<uniform> pens: array<Pen, MAX_PENS>;
@group(0) @binding(2) var cel: texture_2d<f32>;
@group(0) @binding(3) var ink: texture_2d<u32>;
@group(0) @binding(4) var around: texture_2d<f32>;
@group(0) @binding(5) var under: texture_2d<f32>;
@group(0) @binding(6) var linear: sampler;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let first = vec2i(position.xy) * compose.samples;
    var below = under_at(position.xy);
    if compose.is_grey != 0u {
        below = vec4f(monochrome(below.rgb), below.a);
    }
    var sum = vec4f(0.0);
    for (var y = 0; y < compose.samples; y++) {
        for (var x = 0; x < compose.samples; x++) {
            let at = first + vec2i(x, y);
            sum += inked(textureLoad(cel, at, 0), line_at(at));
        }
    }
    sum /= f32(compose.samples * compose.samples);
    let over = sum + vec4f(decoded(below.rgb) * below.a, below.a) * (1.0 - sum.a);
    return vec4f(encoded(over.rgb / max(over.a, 1e-6)), over.a);
}
