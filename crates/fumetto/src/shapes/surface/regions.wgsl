// Finds the regions that particles touch, and keeps just these.
//
// Nobody knows beforehand how many these are: regions are marked and counted first with cells as large as asked
// for. If they have no room, or lists would have none, all regions of a lattice with larger cells are kept.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read_write> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<PackedBlob>;
// 1 for each region that a particle touches. Behind them, how many blocks particles can touch together. All are
// zero before and after.
@group(0) @binding(3) var<storage, read_write> marks: array<atomic<u32>>;
// How many marks there are before each region.
@group(0) @binding(4) var<storage, read> ranks: array<u32>;
// The first block of each region that is kept.
@group(0) @binding(5) var<storage, read_write> kept: array<vec3i>;

const SIDE: i32 = REGION * BLOCK;

var<workgroup> touched: atomic<u32>;

fn mark_touched(grid: Grid, blob: Blob, sharer: u32, sharers: u32) {
    let ball = ball_of(grid, blob, SIDE);
    for (var row = first_row(ball, sharer, sharers); row.at.y < ball.size.z; row = next_row(ball, row)) {
        let touched = touched_in(ball, row);
        for (var x = touched.x; x <= touched.y; x++) {
            let place = vec3i(x, ball.first.yz + row.at) - grid.first / REGION;
            let mark = number_in(grid.regions, vec3u(place));
            // Most are marked already, and looking is cheaper.
            if atomicLoad(&marks[mark]) == 0u {
                atomicStore(&marks[mark], 1u);
            }
        }
    }
}

@compute @workgroup_size(64)
fn mark(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let grid = grid();
    let sharers = recipe.sharers;
    let invocation = (group.y * groups.x + group.x) * 64u + lane;
    let item = invocation >> firstTrailingBit(sharers);
    let sharer = invocation & (sharers - 1u);
    if item < recipe.count {
        let blob = unpacked(blobs[item]);
        mark_touched(grid, blob, sharer, sharers);
        if sharer == 0u {
            atomicAdd(&touched, count_in(vec3u(ball_of(grid, blob, BLOCK).size)));
        }
    }
    workgroupBarrier();
    if lane == 0u {
        atomicAdd(&marks[recipe.regions], atomicLoad(&touched));
    }
}

@compute @workgroup_size(1)
fn choose() {
    let entries = atomicExchange(&marks[recipe.regions], 0u);
    lattice.kept = ranks[recipe.regions];
    if lattice.kept > recipe.blocks / IN_REGION || entries > recipe.entries {
        lattice.first = lattice.safe_first;
        lattice.cell_m = lattice.safe_cell_m;
        lattice.regions = lattice.safe_regions;
        lattice.kept = count_in(lattice.safe_regions);
        lattice.overflow = COARSENED;
    }
}

@compute @workgroup_size(256)
fn keep(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let region = (group.y * groups.x + group.x) * 256u + lane;
    if region >= recipe.regions {
        return;
    }
    let is_marked = atomicExchange(&marks[region], 0u) == 1u;
    if region >= count_in(lattice.regions) {
        return;
    }
    let all = lattice.kept == count_in(lattice.regions);
    let rank = select(select(NOWHERE, ranks[region], is_marked), region, all);
    lattice.table[region] = rank;
    if rank != NOWHERE {
        kept[rank] = lattice.first + place_in(lattice.regions, region) * REGION;
    }
}
