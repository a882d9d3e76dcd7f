// A puff: one particle as it is drawn.
struct Puff {
    center: vec3f,
    // Zero when there is none.
    radius: f32,
    // Variant in bits 0..8, object in bits 8..16, rotation in bits 16..32.
    look: u32,
    // Erosion in bits 0..16, opacity in bits 16..32, both as fractions of 65535.
    fade: u32,
    // Relative to its neighbours.
    mass: f32,
    pad: f32,
}

fn puff_variant(puff: Puff) -> u32 {
    return puff.look & 0xffu;
}

fn puff_object(puff: Puff) -> u32 {
    return (puff.look >> 8u) & 0xffu;
}

// In-plane rotation: cosine and sine.
fn puff_rotation(puff: Puff) -> vec2f {
    let angle = f32(puff.look >> 16u) * (6.2831853 / 65536.0);
    return vec2f(cos(angle), sin(angle));
}

// Erosion and opacity.
fn puff_fade(puff: Puff) -> vec2f {
    return unpack2x16unorm(puff.fade);
}
