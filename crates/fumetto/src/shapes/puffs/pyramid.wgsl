// The occlusion pyramid: for every cell of the screen, how near something solid surely is.
//
// Nearness is the bit pattern of 1 / distance: a positive float orders as its bits do, so integer
// atomics keep the nearest, in any order, exactly.

// Width of a cell of level 0, in pixels.
const CELL_PX: f32 = 2.0;

struct Pyramid {
    levels: u32,
    // Per level: offset, width, height.
    level: array<vec4u, 16>,
}
