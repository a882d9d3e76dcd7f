// Sums of the joints of all lines before each: where its own begin. One workgroup; each lane takes a stretch.

@group(0) @binding(0) var<uniform> tally: Tally;
@group(0) @binding(1) var<storage, read> totals: array<u32>;
@group(0) @binding(2) var<storage, read_write> starts: array<u32>;
@group(0) @binding(3) var<storage, read> joints: array<Joint>;
@group(0) @binding(4) var<storage, read_write> joint_tally: Tally;
// Arguments of a draw over all joints.
@group(0) @binding(5) var<storage, read_write> draw: vec4u;
@group(0) @binding(6) var<uniform> passes: u32;

var<workgroup> sums: array<u32, 256>;

@compute @workgroup_size(256)
fn main(@builtin(local_invocation_index) lane: u32) {
    let stretch = (tally.count + 255u) / 256u;
    let first = min(lane * stretch, tally.count);
    let end = min(first + stretch, tally.count);
    var sum = 0u;
    for (var item = first; item < end; item++) {
        sum += totals[item];
    }
    sums[lane] = sum;
    workgroupBarrier();
    var before = 0u;
    for (var other = 0u; other < lane; other++) {
        before += sums[other];
    }
    for (var item = first; item < end; item++) {
        starts[item] = before;
        before += totals[item];
    }
    if lane == 255u {
        let count = min(before, arrayLength(&joints));
        joint_tally = tally_of(count);
        draw = vec4u(6u * count, passes, 0u, 0u);
    }
}
