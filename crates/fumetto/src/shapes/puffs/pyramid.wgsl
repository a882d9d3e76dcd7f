// The occlusion pyramid: for every cell of the screen, how near everything in it is at least.
//
// Nearness is the bit pattern of the reverse-Z depth: a positive float orders as its bits do, so integers
// compare, and atomics keep the nearest exactly, in any order.

// Width of a cell of level 0, in pixels.
const CELL_PX: f32 = 4.0;

struct Pyramid {
    levels: u32,
    // Per level: offset, width, height.
    level: array<vec4u, 16>,
}

// Bits of a puff's flags.
const FRONT: u32 = 1u;
const REST: u32 = 2u;
const INK: u32 = 4u;
