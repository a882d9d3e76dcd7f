// Where an object's density and light are sampled: in the middles of cubic cells. Light has larger ones, in
// the same box.
struct VolumeGrid {
    // Corner of the first cell.
    origin: vec3f,
    // Side of a cell, in metres.
    cell_m: f32,
    // Of the density; none where there is no matter.
    cells: vec3u,
    light_cell_m: f32,
    light_cells: vec3u,
    pad: f32,
}

// Cells along the side of a block, which is looked into only if there is matter in it. Also in `field.rs`.
const BLOCK: u32 = 8u;

fn block_number(at: vec3u, cells: vec3u) -> u32 {
    let blocks = (cells + BLOCK - 1u) / BLOCK;
    return (at.z * blocks.y + at.y) * blocks.x + at.x;
}
