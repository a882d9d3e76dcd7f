// Lays the backdrop of a picture that is painted straight into.

@group(0) @binding(0) var<uniform> compose: Compose;
@group(0) @binding(1) var under: texture_2d<f32>;
@group(0) @binding(2) var linear: sampler;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return under_at(position.xy);
}
