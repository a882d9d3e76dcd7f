// Sums of all that comes before each item.

struct Scan {
    items: u32,
}

// Items that one invocation looks at.
const RUN: u32 = 32u;

@group(0) @binding(0) var<uniform> scan: Scan;
@group(0) @binding(1) var<storage, read> values: array<u32>;
// Sum of each run; then the sum of all runs before it.
@group(0) @binding(2) var<storage, read_write> runs: array<u32>;
// One more than there are items: the last is the sum of all.
@group(0) @binding(3) var<storage, read_write> starts: array<u32>;

fn run_of(group: vec3u, groups: vec3u, lane: u32) -> u32 {
    return (group.y * groups.x + group.x) * 256u + lane;
}

@compute @workgroup_size(256)
fn reduce(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let run = run_of(group, groups, lane);
    if run * RUN >= scan.items {
        return;
    }
    var sum = 0u;
    for (var item = run * RUN; item < min((run + 1u) * RUN, scan.items); item++) {
        sum += values[item];
    }
    runs[run] = sum;
}

var<workgroup> sums: array<u32, 256>;

// One workgroup sums the runs; each lane takes a stretch of them.
@compute @workgroup_size(256)
fn sum_runs(@builtin(local_invocation_index) lane: u32) {
    let count = (scan.items + RUN - 1u) / RUN;
    let stretch = (count + 255u) / 256u;
    let first = min(lane * stretch, count);
    let end = min(first + stretch, count);
    var sum = 0u;
    for (var run = first; run < end; run++) {
        sum += runs[run];
    }
    sums[lane] = sum;
    workgroupBarrier();
    var before = 0u;
    for (var other = 0u; other < lane; other++) {
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
    if run * RUN >= scan.items {
        return;
    }
    let end = min((run + 1u) * RUN, scan.items);
    var before = runs[run];
    for (var item = run * RUN; item < end; item++) {
        starts[item] = before;
        before += values[item];
    }
    if end == scan.items {
        starts[end] = before;
    }
}
