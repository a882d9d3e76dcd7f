// Pieces of lines, before they are put in order.

// A piece between two ends, which others may share.
struct Record {
    // Pixels from the picture's top left, and depth.
    start: vec3f,
    pen: u32,
    end: vec3f,
    candidate: u32,
    // What tells its ends from others: of the start, then of the end.
    ends: vec4u,
    // The least of a closed line is where that begins.
    key: u32,
    // In the world, octahedral.
    direction: u32,
    // Toward the outside of the body, on the picture, as two snorm16.
    outward: u32,
    // Share of the first light that falls there, and the length in heights, as two halves.
    lit_length: u32,
}

// How many there are, and workgroups for as many.
struct Tally {
    groups: vec3u,
    count: u32,
}

const NONE: u32 = 0xffffffffu;

fn tally_of(count: u32) -> Tally {
    return Tally(vec3u((count + 255u) / 256u, 1u, 1u), count);
}
