// What is cast: the shadows of one light, into the mask.
struct Casting {
    // Of all puffs.
    count: u32,
    light: u32,
    // Bit of the light's in every texel of the mask.
    channel: u32,
    // Pixels of the picture along a texel of the mask.
    step: f32,
    // Of the mask, in texels.
    size: vec2u,
}

// Bits of a puff's flags: a small volume, a large one.
const CASTS_SMALL: u32 = 1u;
const CASTS_LARGE: u32 = 2u;

// Bits of a texel in the mask: one for each light that throws shadows.
const TEXEL_BITS: u32 = 4u;
