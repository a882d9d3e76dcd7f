// Writes an object's puffs into the grid, all of them as one field: colour times density, and density; and
// which puff is the densest in each cell.
//
// Each workgroup lists the puffs that touch its cells as bits, so that they are added up in their own order
// and the sum is the same in every run.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> grid: VolumeGrid;
@group(0) @binding(2) var<storage, read> puffs: array<Puff>;
@group(0) @binding(3) var density: texture_storage_3d<rgba16float, write>;
@group(0) @binding(4) var owners: texture_storage_3d<r32uint, write>;

// Puffs that are looked at in one go.
const RUN: u32 = 256u;

// The largest density that a half float holds, with room for colour.
const DENSEST: f32 = 60000.0;

var<workgroup> touching: array<atomic<u32>, 8>;

fn touches(ball: Ball, low: vec3f, high: vec3f) -> bool {
    let off = clamp(ball.center, low, high) - ball.center;
    let reach = ball_reach(ball) + grid.cell_m;
    return ball.radius > 0.0 && dot(off, off) <= reach * reach;
}

@compute @workgroup_size(8, 8, 4)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_id) local: vec3u, @builtin(local_invocation_index) lane: u32) {
    let first = group * vec3u(8u, 8u, 4u);
    let low = grid.origin + vec3f(first) * grid.cell_m;
    let high = low + vec3f(8.0, 8.0, 4.0) * grid.cell_m;
    let cell = first + local;
    let place = grid.origin + (vec3f(cell) + 0.5) * grid.cell_m;
    var sum = vec4f(0.0);
    var closest = -1e30;
    var owner = 0u;
    for (var run = 0u; run < recipe.count; run += RUN) {
        if lane < 8u {
            atomicStore(&touching[lane], 0u);
        }
        workgroupBarrier();
        if run + lane < recipe.count && touches(ball_of(puffs[recipe.first + run + lane]), low, high) {
            atomicOr(&touching[lane / 32u], 1u << (lane % 32u));
        }
        workgroupBarrier();
        for (var word = 0u; word < 8u; word++) {
            for (var bits = atomicLoad(&touching[word]); bits != 0u; bits &= bits - 1u) {
                let number = recipe.first + run + 32u * word + firstTrailingBit(bits);
                let ball = ball_of(puffs[number]);
                let amount = ball_density(ball, place, grid.cell_m);
                sum += amount * vec4f(ball.colour, 1.0);
                // Just outside, where a surface between cells may lie, the nearest puff takes the place.
                let outside = -distance(place, ball.center) / ball_reach(ball);
                let hold = select(outside, amount, amount > 0.0);
                owner = select(owner, number + 1u, hold > closest);
                closest = max(closest, hold);
            }
        }
        workgroupBarrier();
    }
    if all(cell < grid.cells) {
        textureStore(density, cell, min(sum, vec4f(DENSEST)));
        textureStore(owners, cell, vec4u(owner));
    }
}
