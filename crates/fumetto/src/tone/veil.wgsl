// Blends a cel's flat tones with the volume as a camera would see it.

struct Veil {
    // Of the camera's view.
    soft: f32,
    // Of the object.
    opacity: f32,
}

@group(0) @binding(0) var<uniform> veil: Veil;
@group(0) @binding(1) var cel: texture_2d<f32>;
@group(0) @binding(2) var soft: texture_2d<f32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let px = vec2i(position.xy);
    let tone = textureLoad(cel, px, 0);
    let seen = textureLoad(soft, px, 0) * veil.opacity;
    let mixed = mix(vec4f(decoded(tone.rgb) * tone.a, tone.a), seen, veil.soft);
    return vec4f(encoded(mixed.rgb / max(mixed.a, 1e-6)), mixed.a);
}
