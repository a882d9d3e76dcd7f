// What a paint does to what it covers.
struct Coat {
    // Where it stays.
    keep_low: vec3f,
    // Half the width of the line along its edge: the larger of the two counts.
    line_px: f32,
    keep_high: vec3f,
    line_m: f32,
    // Encoded.
    line_colour: vec3f,
    // Number of the look in which it shows what it covers.
    look: u32,
    // Linear.
    wash_colour: vec3f,
    // 0 where it lays nothing on.
    wash_strength: f32,
    // Bits of a pixel that tell in which of its layers it lies.
    bits: u32,
    flags: u32,
}

struct Coats {
    bodies: u32,
    count: u32,
    // What no paint covers: number of its look, and flags.
    look: u32,
    flags: u32,
    // In the order in which they lie on each other.
    coats: array<Coat, MAX_COATS>,
}

const MAX_COATS: u32 = 12u;

// Flags: shades of grey; washes hide what they cover.
const MONOCHROME: u32 = 1u;
const COVERS: u32 = 2u;

// Of what a pixel knows: a bit for each layer that it lies in, and above these the number of the paint whose line
// it lies on.
const LAYER_BITS: u32 = 12u;
