// Lays the grid around an object's matter. Minima and maxima are the same in any order.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<uniform> room: Room;
@group(0) @binding(2) var<storage, read> puffs: array<Puff>;
@group(0) @binding(3) var<storage, read_write> grid: VolumeGrid;

// Cells that there is room for.
struct Room {
    cells: vec3u,
    pad: u32,
    light_cells: vec3u,
}

// Cells that lie outside the matter: one at each end, so that what is sampled between cells ends in nothing,
// and one for a grid that lies on multiples of its cells. Also in `volume_plan.rs`.
const MARGIN: f32 = 3.0;

var<workgroup> low: array<vec3f, 256>;
var<workgroup> high: array<vec3f, 256>;

@compute @workgroup_size(256)
fn main(@builtin(local_invocation_index) lane: u32) {
    var own_low = vec3f(3e38);
    var own_high = vec3f(-3e38);
    for (var item = lane; item < recipe.count; item += 256u) {
        let ball = ball_of(puffs[recipe.first + item]);
        if ball.radius > 0.0 {
            own_low = min(own_low, ball.center - ball_reach(ball));
            own_high = max(own_high, ball.center + ball_reach(ball));
        }
    }
    low[lane] = own_low;
    high[lane] = own_high;
    for (var half = 128u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if lane < half {
            low[lane] = min(low[lane], low[lane + half]);
            high[lane] = max(high[lane], high[lane + half]);
        }
    }
    if lane == 0u {
        grid = fitted(low[0], high[0]);
    }
}

fn fitted(least: vec3f, most: vec3f) -> VolumeGrid {
    if any(least > most) {
        return VolumeGrid(vec3f(0.0), 1.0, vec3u(0u), 1.0, vec3u(0u), 0.0);
    }
    let needed = (most - least) / (vec3f(room.cells) - MARGIN);
    var cell_m = max(max(needed.x, max(needed.y, needed.z)), 1e-9);
    if recipe.moves != 0u {
        // Steps of a quarter of an octave: cells seldom change while smoke grows.
        cell_m = exp2(ceil(4.0 * log2(cell_m)) / 4.0);
    }
    let origin = (floor(least / cell_m) - 1.0) * cell_m;
    let ratio = vec3f(room.cells) / vec3f(room.light_cells);
    let light_cell_m = cell_m * max(ratio.x, max(ratio.y, ratio.z));
    return VolumeGrid(origin, cell_m, room.cells, light_cell_m, room.light_cells, 0.0);
}
