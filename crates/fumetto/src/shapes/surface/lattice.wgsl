// Where the field is sampled: a cubic lattice that is anchored at the world's origin, so that it does not
// swim over moving smoke. It comes in blocks of 4³ cells; a block owns its cells and the points at their
// lower corners, and a point owns the lattice edges that lead from it along +x, +y and +z.

const BLOCK: i32 = 4;

struct Lattice {
    // The first block, counted in blocks from the world's origin.
    first: vec3i,
    // Side of a cell, in metres.
    cell_m: f32,
    // Blocks along each axis; none where there is no matter.
    blocks: vec3u,
    // Blocks that the surface may cross.
    active_blocks: u32,
    // What did not fit: the bits below.
    overflow: u32,
}

// Cells were made larger, so that blocks and particles fit.
const COARSENED: u32 = 1u;
// Blocks were left out.
const BLOCKS_LEFT_OUT: u32 = 2u;
const VERTICES_LEFT_OUT: u32 = 4u;
const TRIANGLES_LEFT_OUT: u32 = 8u;

// State of a block that the surface does not cross; from `ACTIVE` on it is the block's number among the
// active ones.
const OUTSIDE: u32 = 0u;
const INSIDE: u32 = 1u;
const ACTIVE: u32 = 2u;

const NOWHERE: u32 = 0xffffffffu;

fn block_count(blocks: vec3u) -> u32 {
    return blocks.x * blocks.y * blocks.z;
}

// A block's number from its place, counted from the lattice's first.
fn block_number(blocks: vec3u, at: vec3i) -> u32 {
    if any(at < vec3i(0)) || any(at >= vec3i(blocks)) {
        return NOWHERE;
    }
    return (u32(at.z) * blocks.y + u32(at.y)) * blocks.x + u32(at.x);
}

fn block_place(blocks: vec3u, number: u32) -> vec3i {
    return vec3i(vec3u(number % blocks.x, number / blocks.x % blocks.y, number / (blocks.x * blocks.y)));
}

// A cell's place in its block, and the other way round.
fn local_place(lane: u32) -> vec3u {
    return vec3u(lane, lane >> 2u, lane >> 4u) & vec3u(3u);
}

fn local_number(place: vec3u) -> u32 {
    return place.x | (place.y << 2u) | (place.z << 4u);
}

// A lattice point in the world. Always this product, so that all who ask get the same bits.
fn point_place(point: vec3i, cell_m: f32) -> vec3f {
    return vec3f(point) * cell_m;
}
