// Eddies push the air around them: each workgroup finds those that reach its block, in their order, a round of the list
// at a time.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<uniform> eddies: Eddies;
@group(0) @binding(2) var<storage, read> list: array<Eddy>;
@group(0) @binding(3) var<storage, read_write> push: array<vec2u>;
@group(0) @binding(4) var<storage, read> busy: array<u32>;

// Eddies that are looked at in a round: one for each lane.
const ROUND: u32 = 256u;
// What r (1 - r²)² must be multiplied with to be 1 where it is greatest.
const TO_UNIT: f32 = 3.4939;

var<workgroup> hits: array<u32, ROUND>;
var<workgroup> near: array<Eddy, ROUND>;
var<workgroup> found: u32;

fn reaches(eddy: Eddy, low: vec3f, high: vec3f) -> bool {
    let offset = eddy.position - clamp(eddy.position, low, high);
    return eddy.strength > 0.0 && dot(offset, offset) < eddies.radius * eddies.radius;
}

// Finds those of the round that begins with `first`.
fn gather(first: u32, block: u32, lane: u32) {
    let low = grid.origin + vec3f(block_at(block)) * grid.side;
    let high = low + f32(BLOCK) * grid.side;
    let item = first + lane;
    hits[lane] = select(0u, 1u, item < eddies.all && reaches(list[min(item, eddies.all - 1u)], low, high));
    // The round before has been read, too.
    workgroupBarrier();
    if lane == 0u {
        found = 0u;
        for (var i = 0u; i < ROUND; i++) {
            if hits[i] == 1u {
                near[found] = list[first + i];
                found++;
            }
        }
    }
    workgroupBarrier();
}

// `before`, and what this round adds.
fn stirred(before: vec3f, p: vec3f) -> vec3f {
    var sum = before;
    for (var i = 0u; i < found; i++) {
        let arm = (near[i].position - p) / eddies.radius;
        let left = max(1.0 - dot(arm, arm), 0.0);
        sum += (near[i].strength * TO_UNIT * left * left) * cross(arm, near[i].axis);
    }
    return sum;
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let block = busy[BUSY + group.x];
    var sums = array<vec3f, 2>();
    for (var first = 0u; first < eddies.all; first += ROUND) {
        gather(first, block, lane);
        for (var half = 0u; half < 2u; half++) {
            let p = grid.origin + (vec3f(cell_of(block, lane, half)) + 0.5) * grid.side;
            sums[half] = stirred(sums[half], p);
        }
    }
    for (var half = 0u; half < 2u; half++) {
        add_push(cell_of(block, lane, half), sums[half]);
    }
}
