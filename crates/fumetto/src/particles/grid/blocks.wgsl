// Blocks of 8 × 8 × 8 cells. Those in which there is smoke, and those beside them, are busy: only there is all done
// that smoke shows.

const BLOCK: u32 = 8u;
// The list of busy ones begins here; before it is how many workgroups they take.
const BUSY: u32 = 4u;

fn block_index(c: vec3u) -> u32 {
    let blocks = grid.cells / BLOCK;
    let b = c / BLOCK;
    return (b.z * blocks.y + b.y) * blocks.x + b.x;
}

// The lowest cell of a block.
fn block_at(block: u32) -> vec3u {
    let blocks = grid.cells / BLOCK;
    return BLOCK * vec3u(block % blocks.x, block / blocks.x % blocks.y, block / (blocks.x * blocks.y));
}

// Of the two cells of a block that each lane of a workgroup visits.
fn cell_of(block: u32, lane: u32, half: u32) -> vec3u {
    return block_at(block) + vec3u(lane & 7u, (lane >> 3u) & 7u, (lane >> 6u) + 4u * half);
}
