// Notes in every block's list which particles touch it: first counts, then scatters. Every particle gets
// some invocations, which share the rows of blocks around it: a few where there are many particles, many where there
// are few, which may be large.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<Blob>;
// Particles that touch each block; none before and after.
@group(0) @binding(3) var<storage, read_write> tally: array<atomic<u32>>;
// Where each block's list begins; the next one's start is its end.
@group(0) @binding(4) var<storage, read> starts: array<u32>;
@group(0) @binding(5) var<storage, read_write> entries: array<u32>;

// Where the `index`-th row of blocks along x begins.
fn row_place(around: Around, index: u32) -> vec3i {
    return around.first + vec3i(0, i32(index % around.size.y), i32(index / around.size.y));
}

// The number of the block at a place, if the particle does touch it.
fn touched_block(blob: Blob, place: vec3i) -> u32 {
    if !touches(blob, place, BLOCK) {
        return NOWHERE;
    }
    return block_number(place);
}

@compute @workgroup_size(64)
fn count(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let invocation = (group.y * groups.x + group.x) * 64u + lane;
    let item = invocation / recipe.sharers;
    if item >= recipe.count {
        return;
    }
    let blob = blobs[item];
    let around = around(blob, BLOCK);
    for (var index = invocation % recipe.sharers; index < around.size.y * around.size.z; index += recipe.sharers) {
        let row = row_place(around, index);
        for (var x = 0; x < i32(around.size.x); x++) {
            let block = touched_block(blob, row + vec3i(x, 0, 0));
            if block != NOWHERE {
                atomicAdd(&tally[block], 1u);
            }
        }
    }
}

// Lists are filled from their end, which takes the tallies back to zero for the next frame.
@compute @workgroup_size(64)
fn scatter(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let invocation = (group.y * groups.x + group.x) * 64u + lane;
    let item = invocation / recipe.sharers;
    if item >= recipe.count {
        return;
    }
    let blob = blobs[item];
    let around = around(blob, BLOCK);
    for (var index = invocation % recipe.sharers; index < around.size.y * around.size.z; index += recipe.sharers) {
        let row = row_place(around, index);
        for (var x = 0; x < i32(around.size.x); x++) {
            let block = touched_block(blob, row + vec3i(x, 0, 0));
            if block != NOWHERE {
                entries[starts[block] + atomicSub(&tally[block], 1u) - 1u] = item;
            }
        }
    }
}
