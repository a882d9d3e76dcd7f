// Notes in every block's list which particles touch it: first counts, then scatters. Every particle gets
// some invocations, which share the rows of blocks around it: a few where there are many particles, many where there
// are few, which may be large.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<PackedBlob>;
// Particles that touch each block; none before.
@group(0) @binding(3) var<storage, read_write> tally: array<atomic<u32>>;
// Of each block, one place further: first where its list begins, and at last where it ends.
@group(0) @binding(4) var<storage, read_write> ends: array<atomic<u32>>;
@group(0) @binding(5) var<storage, read_write> entries: array<u32>;

// What one invocation does.
struct Share {
    item: u32,
    sharer: u32,
    // A power of two.
    sharers: u32,
}

fn share_of(invocation: u32) -> Share {
    let shift = firstTrailingBit(recipe.sharers);
    return Share(invocation >> shift, invocation & (recipe.sharers - 1u), recipe.sharers);
}

fn note(block: u32, item: u32, counts: bool) {
    if counts {
        atomicAdd(&tally[block], 1u);
    } else {
        entries[atomicAdd(&ends[block + 1u], 1u)] = item;
    }
}

fn note_touched(grid: Grid, share: Share, counts: bool) {
    let ball = ball_of(grid, unpacked(blobs[share.item]), BLOCK);
    for (var row = first_row(ball, share.sharer, share.sharers); row.at.y < ball.size.z; row = next_row(ball, row)) {
        let touched = touched_in(ball, row);
        var number = NOWHERE;
        for (var x = touched.x; x <= touched.y; x++) {
            // Along x blocks of a region have consecutive numbers.
            if x == touched.x || (x & (REGION - 1)) == 0 {
                number = block_number(grid, vec3i(x, ball.first.yz + row.at));
            }
            if number != NOWHERE {
                note(number, share.item, counts);
                number++;
            }
        }
    }
}

@compute @workgroup_size(64)
fn count(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let grid = grid();
    let share = share_of((group.y * groups.x + group.x) * 64u + lane);
    if share.item < recipe.count {
        note_touched(grid, share, true);
    }
}

@compute @workgroup_size(64)
fn scatter(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let grid = grid();
    let share = share_of((group.y * groups.x + group.x) * 64u + lane);
    if share.item < recipe.count {
        note_touched(grid, share, false);
    }
}
