// Notes in every block's list which particles touch it: first counts, then scatters. Every particle gets
// some invocations, which share the blocks around it: a few where there are many particles, many where there
// are few, which may be large.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<Blob>;
// Particles that touch each block; none before and after.
@group(0) @binding(3) var<storage, read_write> tally: array<atomic<u32>>;
// Where each block's list begins; the next one's start is its end.
@group(0) @binding(4) var<storage, read> starts: array<u32>;
@group(0) @binding(5) var<storage, read_write> entries: array<u32>;

// Blocks around one particle.
struct Around {
    first: vec3i,
    blocks: vec3u,
}

fn around(blob: Blob) -> Around {
    if blob.radius == 0.0 {
        return Around(vec3i(0), vec3u(0u));
    }
    let last = vec3i(last_block(blob.center + blob.radius, lattice.cell_m)) - lattice.first;
    let first = vec3i(first_block(blob.center - blob.radius, lattice.cell_m)) - lattice.first;
    let within = max(first, vec3i(0));
    return Around(within, vec3u(max(min(last, vec3i(lattice.blocks) - 1) - within + 1, vec3i(0))));
}

// The number of the `index`-th block around a particle, if the particle does touch it.
fn touched_block(blob: Blob, around: Around, index: u32) -> u32 {
    let at = around.first + block_place(around.blocks, index);
    let side = f32(BLOCK);
    let low = vec3f((at + lattice.first) * BLOCK);
    let center = blob.center / lattice.cell_m;
    let off = center - clamp(center, low, low + side);
    let reach = blob.radius / lattice.cell_m + SLACK;
    return select(NOWHERE, block_number(lattice.blocks, at), dot(off, off) <= reach * reach);
}

@compute @workgroup_size(64)
fn count(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let invocation = (group.y * groups.x + group.x) * 64u + lane;
    let item = invocation / recipe.sharers;
    if item >= recipe.count {
        return;
    }
    let blob = blobs[item];
    let around = around(blob);
    for (var index = invocation % recipe.sharers; index < block_count(around.blocks); index += recipe.sharers) {
        let block = touched_block(blob, around, index);
        if block != NOWHERE {
            atomicAdd(&tally[block], 1u);
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
    let around = around(blob);
    for (var index = invocation % recipe.sharers; index < block_count(around.blocks); index += recipe.sharers) {
        let block = touched_block(blob, around, index);
        if block != NOWHERE {
            entries[starts[block] + atomicSub(&tally[block], 1u) - 1u] = item;
        }
    }
}
