// Lists the items that have a flag, in their own order, and writes the arguments of a draw over them.

struct Compaction {
    items: u32,
    // Which bit of an item's flags.
    mask: u32,
    // Quads drawn for each listed item.
    quads: u32,
}

// Items that one invocation looks at.
const RUN: u32 = 32u;

@group(0) @binding(0) var<uniform> compaction: Compaction;
@group(0) @binding(1) var<storage, read> flags: array<u32>;
// Flagged items before each run.
@group(0) @binding(2) var<storage, read_write> before: array<u32>;
@group(0) @binding(3) var<storage, read_write> list: array<u32>;
// Indices, instances, first index, base vertex, first instance; then how many are listed.
@group(0) @binding(4) var<storage, read_write> draw: array<u32, 6>;

fn run_of(group: vec3u, groups: vec3u, lane: u32) -> u32 {
    return (group.y * groups.x + group.x) * 256u + lane;
}

fn flagged(run: u32) -> u32 {
    var count = 0u;
    for (var item = run * RUN; item < min((run + 1u) * RUN, compaction.items); item++) {
        count += u32((flags[item] & compaction.mask) != 0u);
    }
    return count;
}

@compute @workgroup_size(256)
fn count(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let run = run_of(group, groups, lane);
    if run * RUN < compaction.items {
        before[run] = flagged(run);
    }
}

var<workgroup> sums: array<u32, 256>;

// One workgroup turns counts into sums of all that is before; each lane takes a stretch of runs.
@compute @workgroup_size(256)
fn scan(@builtin(local_invocation_index) lane: u32) {
    let runs = (compaction.items + RUN - 1u) / RUN;
    let stretch = (runs + 255u) / 256u;
    let first = min(lane * stretch, runs);
    let end = min(first + stretch, runs);
    var sum = 0u;
    for (var run = first; run < end; run++) {
        sum += before[run];
    }
    sums[lane] = sum;
    workgroupBarrier();
    var total = 0u;
    for (var other = 0u; other < lane; other++) {
        total += sums[other];
    }
    for (var run = first; run < end; run++) {
        let count = before[run];
        before[run] = total;
        total += count;
    }
    if lane == 255u {
        draw = array(total * compaction.quads * 6u, 1u, 0u, 0u, 0u, total);
    }
}

@compute @workgroup_size(256)
fn scatter(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let run = run_of(group, groups, lane);
    if run * RUN >= compaction.items {
        return;
    }
    var at = before[run];
    for (var item = run * RUN; item < min((run + 1u) * RUN, compaction.items); item++) {
        if (flags[item] & compaction.mask) != 0u {
            list[at] = item;
            at++;
        }
    }
}
