// Noise between lattice points of a plane, from 0 to 1.
fn grain(p: vec2f, key: u32) -> f32 {
    let cell = vec2i(floor(p));
    let w = p - floor(p);
    let u = w * w * (3.0 - 2.0 * w);
    var corners: array<f32, 4>;
    for (var corner = 0; corner < 4; corner++) {
        let at = vec2u(cell + vec2i(corner & 1, corner >> 1));
        corners[corner] = f32(pcg(key ^ (at.x * 1597334677u) ^ (at.y * 3812015801u)) >> 8u) / 16777216.0;
    }
    return mix(mix(corners[0], corners[1], u.x), mix(corners[2], corners[3], u.x), u.y);
}

// Standard deviation of `grain`: that of a number from 0 to 1, 1/sqrt(12), times what is left of it on average
// between four of them, 26/35.
const GRAIN_DEVIATION: f32 = 0.2144;

// The same with cells of about the size `cell`, which may change from place to place: lattices of two sizes,
// both powers of two, go over into each other, so that none of it slides. Of mean 0 and the deviation above.
fn steady_grain(p: vec2f, cell: f32, key: u32) -> f32 {
    let octave = log2(cell);
    let low = floor(octave);
    let part = octave - low;
    let fine = grain(p * exp2(-low), key + u32(i32(low)) * 747796405u) - 0.5;
    let coarse = grain(p * exp2(-low - 1.0), key + u32(i32(low) + 1) * 747796405u) - 0.5;
    // Two numbers that know nothing of each other spread less when they are mixed.
    return mix(fine, coarse, part) / sqrt(part * part + (1.0 - part) * (1.0 - part));
}
