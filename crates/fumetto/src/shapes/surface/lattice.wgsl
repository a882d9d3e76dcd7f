// Where the field is sampled: a cubic lattice that is anchored at the world's origin, so that it does not
// swim over moving smoke. It comes in blocks of 4³ cells; a block owns its cells and the points at their
// lower corners, and a point owns the lattice edges that lead from it along +x, +y and +z.
//
// Blocks come in regions of 8³. Only regions that a particle touches are kept, so that what lies between two
// clouds takes no more than a word of the table for each region. Places of blocks and regions are counted from
// the world's origin.

const BLOCK: i32 = 4;
// Blocks along a region's side, and in all of it.
const REGION: i32 = 8;
const IN_REGION: u32 = 512u;

struct Lattice {
    // The first block of the first region.
    first: vec3i,
    // Side of a cell, in metres.
    cell_m: f32,
    // Regions along each axis; none where there is no matter.
    regions: vec3u,
    // Blocks that the surface may cross.
    active_blocks: u32,
    // What the first three are if there is too little room: with cells so large that it fits for sure.
    safe_first: vec3i,
    safe_cell_m: f32,
    safe_regions: vec3u,
    // Regions that are kept.
    kept: u32,
    // What did not fit: the bits below.
    overflow: u32,
    // The largest particle's radius.
    widest_m: f32,
    // Which of the kept ones each region is, or `NOWHERE`.
    table: array<u32>,
}

// A block that the surface may cross.
struct ActiveBlock {
    place: vec3i,
    number: u32,
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

// Where blocks lie. Kernels read it once, while all invocations still go the same way: a processor that draws reads
// for each invocation on its own wherever they may not.
struct Grid {
    first: vec3i,
    cell_m: f32,
    regions: vec3u,
}

fn grid() -> Grid {
    return Grid(lattice.first, lattice.cell_m, lattice.regions);
}

// How many there are in a box.
fn count_in(box: vec3u) -> u32 {
    return box.x * box.y * box.z;
}

// A number from a place in a box, and the other way round.
fn number_in(box: vec3u, at: vec3u) -> u32 {
    return (at.z * box.y + at.y) * box.x + at.x;
}

fn place_in(box: vec3u, number: u32) -> vec3i {
    return vec3i(vec3u(number % box.x, number / box.x % box.y, number / (box.x * box.y)));
}

// The number of the block at a place, if its region is kept.
fn block_number(grid: Grid, place: vec3i) -> u32 {
    let at = place - grid.first;
    let region = at >> vec3u(3u);
    if any(region < vec3i(0)) || any(region >= vec3i(grid.regions)) {
        return NOWHERE;
    }
    let kept = lattice.table[number_in(grid.regions, vec3u(region))];
    let within = vec3u(at & vec3i(REGION - 1));
    return select(kept * IN_REGION + (within.x | (within.y << 3u) | (within.z << 6u)), NOWHERE, kept == NOWHERE);
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
