// Lists the busy blocks, in their own order, in one workgroup.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read> sources: array<Source>;
// 1: there is smoke in the block.
@group(0) @binding(2) var<storage, read_write> smoky: array<u32>;
@group(0) @binding(3) var<storage, read_write> busy: array<u32>;

const LANES: u32 = 256u;
// Half the diagonal of a block, and a cell, in cells.
const REACH: f32 = 8.0;

var<workgroup> ends: array<u32, 256>;

fn is_busy(block: u32) -> bool {
    let low = vec3i(block_at(block) / BLOCK);
    let blocks = vec3i(grid.cells / BLOCK);
    for (var z = max(low.z - 1, 0); z < min(low.z + 2, blocks.z); z++) {
        for (var y = max(low.y - 1, 0); y < min(low.y + 2, blocks.y); y++) {
            for (var x = max(low.x - 1, 0); x < min(low.x + 2, blocks.x); x++) {
                if smoky[(z * blocks.y + y) * blocks.x + x] == 1u {
                    return true;
                }
            }
        }
    }
    let middle = grid.origin + (vec3f(block_at(block)) + 0.5 * f32(BLOCK)) * grid.side;
    for (var i = 0u; i < grid.sources; i++) {
        if distance_from(sources[i], middle) < REACH * grid.side {
            return true;
        }
    }
    return false;
}

// Each lane takes as many blocks, one after the other.
@compute @workgroup_size(256)
fn main(@builtin(local_invocation_index) lane: u32) {
    let blocks = grid.cells / BLOCK;
    let count = blocks.x * blocks.y * blocks.z;
    let share = (count + LANES - 1u) / LANES;
    let first = min(lane * share, count);
    let last = min(first + share, count);
    var own = 0u;
    for (var block = first; block < last; block++) {
        own += u32(is_busy(block));
    }
    ends[lane] = own;
    workgroupBarrier();
    var place = BUSY;
    for (var before = 0u; before < lane; before++) {
        place += ends[before];
    }
    for (var block = first; block < last; block++) {
        if is_busy(block) {
            busy[place] = block;
            place++;
        }
    }
    if lane == LANES - 1u {
        busy[0] = place - BUSY;
        busy[1] = 1u;
        busy[2] = 1u;
    }
    storageBarrier();
    // The step finds out anew where there is smoke.
    for (var block = first; block < last; block++) {
        smoky[block] = 0u;
    }
}
