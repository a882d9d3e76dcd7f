// Finds the regions that particles touch, and keeps just these.
//
// Nobody knows beforehand how many these are: regions are marked and counted first with cells as large as asked
// for. If they have no room, or lists would have none, all regions of a lattice with larger cells are kept.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read_write> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<Blob>;
// 1 for each region that a particle touches. Behind them, how many blocks particles can touch together. All are
// zero before and after.
@group(0) @binding(3) var<storage, read_write> marks: array<atomic<u32>>;
// How many marks there are before each region.
@group(0) @binding(4) var<storage, read> ranks: array<u32>;
// Regions that are kept.
@group(0) @binding(5) var<storage, read_write> kept: array<u32>;

const SIDE: i32 = REGION * BLOCK;

var<workgroup> touched: atomic<u32>;

fn mark_around(blob: Blob, sharer: u32) {
    let around = around(blob, SIDE);
    for (var index = sharer; index < count_in(around.size); index += recipe.sharers) {
        let place = around.first + place_in(around.size, index);
        if touches(blob, place, SIDE) {
            let mark = number_in(lattice.regions, vec3u(place - lattice.first / REGION));
            // Most are marked already, and looking is cheaper.
            if atomicLoad(&marks[mark]) == 0u {
                atomicStore(&marks[mark], 1u);
            }
        }
    }
}

@compute @workgroup_size(64)
fn mark(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let invocation = (group.y * groups.x + group.x) * 64u + lane;
    let item = invocation / recipe.sharers;
    let sharer = invocation % recipe.sharers;
    if item < recipe.count {
        let blob = blobs[item];
        mark_around(blob, sharer);
        if sharer == 0u {
            atomicAdd(&touched, count_in(around(blob, BLOCK).size));
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
        kept[rank] = region;
    }
}
