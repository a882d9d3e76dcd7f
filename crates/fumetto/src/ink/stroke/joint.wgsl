// Points along lines, in order: those of one line follow each other.
struct Joint {
    // From the picture's top left.
    px: vec2f,
    depth: f32,
    // From the beginning of the line, in heights.
    along: f32,
    // Toward the outside of the body, as two snorm16.
    outward: u32,
    pen: u32,
    candidate: u32,
    // The first and the last joint of the line.
    first: u32,
    last: u32,
    // Whether the line is closed; then its last joint lies on its first.
    is_closed: u32,
    // Share of the first light that falls there.
    lit: f32,
    pad: u32,
}
