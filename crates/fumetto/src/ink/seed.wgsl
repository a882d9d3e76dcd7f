// A place that a line runs through, as the flood carries it; all bits are 0 where there is none.
//
// x: the pixel's column in bits 0..14 and its row in bits 14..28, then how far the line runs beside its
// middle: 0 to 8 for left above to right below. y: half the width of the line in pixels times 64 in bits 0..16,
// its pen + 1 in bits 16..24 and its opacity in bits 24..32, both as in the ink layer.
alias Seed = vec2u;

// `aside` is toward the neighbours on whose borders the line runs, by -1, 0 or 1 along each axis.
fn seed_of(px: vec2i, aside: vec2i, half_width_px: f32, mark: vec2u) -> Seed {
    let place = u32(px.x) | (u32(px.y) << 14u) | (u32(aside.x + 1 + 3 * (aside.y + 1)) << 28u);
    return Seed(place, u32(clamp(half_width_px * 64.0, 0.0, 65535.0)) | (mark.x << 16u) | (mark.y << 24u));
}

fn seed_px(seed: Seed) -> vec2u {
    return vec2u(seed.x & 0x3fffu, (seed.x >> 14u) & 0x3fffu);
}

fn seed_half_width_px(seed: Seed) -> f32 {
    return f32(seed.y & 0xffffu) / 64.0;
}

// How far a place is outside the line that runs through the seed; below 0 inside.
fn outside_px(seed: Seed, position: vec2f) -> f32 {
    if seed.y == 0u {
        return 1e9;
    }
    let code = seed.x >> 28u;
    let aside = vec2f(f32(code % 3u), f32(code / 3u)) - 1.0;
    // On the border to one neighbour; between two, halfway between the middles of both borders.
    let middle = vec2f(seed_px(seed)) + 0.5 + 0.5 * aside / max(dot(aside, aside), 1.0);
    return distance(position, middle) - seed_half_width_px(seed);
}
