// The occlusion pyramid: for every cell of the screen, how near everything in it is at least.
//
// Nearness is the bit pattern of the reverse-Z depth: a positive float orders as its bits do.

// Width of a cell of level 0, in pixels.
const CELL_PX: f32 = 4.0;

struct Pyramid {
    levels: u32,
    // Per level: offset, width, height.
    level: array<vec4u, 16>,
}
