// Solves the coarsest level, of at most 4096 cells, in one workgroup by successive over-relaxation.

const SWEEPS: u32 = 24u;
// Close to the best for 16 cells along a side: 2 / (1 + sin(π/16)), a little more for walls that are closed.
const RELAXATION: f32 = 1.7;
const LANES: u32 = 256u;

// All of the 16 KiB that a workgroup has by WebGPU's default.
var<workgroup> solved: array<f32, 4096>;

// The sum of all lanes' values, for which `solved` is overwritten.
fn sum_of(value: f32, lane: u32) -> f32 {
    solved[lane] = value;
    for (var half = LANES / 2u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if lane < half {
            solved[lane] += solved[lane + half];
        }
    }
    let sum = workgroupUniformLoad(&solved[0]);
    return sum;
}

@compute @workgroup_size(256)
fn main(@builtin(local_invocation_index) lane: u32) {
    let count = level.cells.x * level.cells.y * level.cells.z;
    var total = 0.0;
    for (var i = lane; i < count; i += LANES) {
        total += wanted[level.first + i];
    }
    // Between closed walls there is a solution only where all adds up to zero.
    let mean = select(0.0, sum_of(total, lane) / f32(count), level.open == 0u);
    for (var i = lane; i < count; i += LANES) {
        solved[i] = 0.0;
    }
    workgroupBarrier();
    for (var turn = 0u; turn < 2u * SWEEPS; turn++) {
        for (var i = lane; i < count; i += LANES) {
            let c = vec3u(i % level.cells.x, i / level.cells.x % level.cells.y, i / (level.cells.x * level.cells.y));
            if ((c.x + c.y + c.z + turn) & 1u) == 0u {
                relax(i, c, wanted[level.first + i] - mean);
            }
        }
        workgroupBarrier();
    }
    total = 0.0;
    for (var i = lane; i < count; i += LANES) {
        total += solved[i];
        pressure[level.first + i] = solved[i];
    }
    workgroupBarrier();
    // Only differences matter then: without this their sum would drift.
    let level_of_all = select(0.0, sum_of(total, lane) / f32(count), level.open == 0u);
    for (var i = lane; i < count; i += LANES) {
        pressure[level.first + i] -= level_of_all;
    }
}

fn relax(i: u32, c: vec3u, right: f32) {
    let stride = vec3u(1u, level.cells.x, level.cells.x * level.cells.y);
    let low = c == vec3u(0u);
    let high = c + 1u == level.cells;
    let before = i - select(stride, vec3u(0u), low);
    let after = i + select(stride, vec3u(0u), high);
    var sum = select(vec3f(solved[before.x], solved[before.y], solved[before.z]), vec3f(0.0), low);
    sum += select(vec3f(solved[after.x], solved[after.y], solved[after.z]), vec3f(0.0), high);
    let own = weight_of(low, high);
    solved[i] = mix(solved[i], (sum.x + sum.y + sum.z - right) / own, RELAXATION);
}
