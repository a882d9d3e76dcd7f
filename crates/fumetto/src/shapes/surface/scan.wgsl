// Sums of all that comes before each item.

struct Scan {
    items: u32,
    // How many places further sums are written.
    shift: u32,
}

// Items that one invocation looks at.
const RUN: u32 = 32u;

@group(0) @binding(0) var<uniform> scan: Scan;
@group(0) @binding(1) var<storage, read> values: array<Item>;
// Sum of each run; then the sum of all runs before it.
@group(0) @binding(2) var<storage, read_write> runs: array<Item>;
// One more than there are items: without a shift the last is the sum of all, with one the first is none.
@group(0) @binding(3) var<storage, read_write> starts: array<Item>;

fn run_of(group: vec3u, groups: vec3u, lane: u32) -> u32 {
    return (group.y * groups.x + group.x) * 256u + lane;
}

@compute @workgroup_size(256)
fn reduce(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let run = run_of(group, groups, lane);
    let end = min((run + 1u) * RUN, scan.items);
    if run * RUN >= end {
        return;
    }
    var sum = Item();
    for (var item = run * RUN; item < end; item++) {
        sum += values[item];
    }
    runs[run] = sum;
}

var<workgroup> sums: array<Item, 256>;
// Of sixteen lanes each.
var<workgroup> larger_sums: array<Item, 16>;

// One workgroup sums the runs; each lane takes a stretch of them.
@compute @workgroup_size(256)
fn sum_runs(@builtin(local_invocation_index) lane: u32) {
    let count = (scan.items + RUN - 1u) / RUN;
    let stretch = (count + 255u) / 256u;
    let first = min(lane * stretch, count);
    let end = min(first + stretch, count);
    var sum = Item();
    for (var run = first; run < end; run++) {
        sum += runs[run];
    }
    sums[lane] = sum;
    workgroupBarrier();
    if lane < 16u {
        var larger = Item();
        for (var other = 0u; other < 16u; other++) {
            larger += sums[16u * lane + other];
        }
        larger_sums[lane] = larger;
    }
    workgroupBarrier();
    var before = Item();
    for (var other = 0u; other < lane / 16u; other++) {
        before += larger_sums[other];
    }
    for (var other = lane / 16u * 16u; other < lane; other++) {
        before += sums[other];
    }
    for (var run = first; run < end; run++) {
        let own = runs[run];
        runs[run] = before;
        before += own;
    }
}

@compute @workgroup_size(256)
fn spread(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let run = run_of(group, groups, lane);
    let items = scan.items;
    let shift = scan.shift;
    let end = min((run + 1u) * RUN, items);
    if run * RUN >= end {
        return;
    }
    var before = runs[run];
    for (var item = run * RUN; item < end; item++) {
        starts[item + shift] = before;
        before += values[item];
    }
    if shift == 0u && end == items {
        starts[end] = before;
    }
    if shift == 1u && run == 0u {
        starts[0] = Item();
    }
}
