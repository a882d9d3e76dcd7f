// Finds the blocks that the surface of a file's density can cross, without sampling any: over a block's box the density
// lies between the least and the most of the bricks that it meets. `blocks.wgsl` says the same of particles.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var linear: sampler;
// The least and the most density in each slot of the atlas.
@group(0) @binding(6) var<storage, read> extremes: array<vec2f>;
// The first block of each region that is kept.
@group(0) @binding(7) var<storage, read> kept: array<vec3i>;
@group(0) @binding(8) var<storage, read_write> states: array<u32>;
// 1 where the surface may cross the block.
@group(0) @binding(9) var<storage, read_write> crossed: array<u32>;

// What bounds are widened by: more than the texture unit's rounding.
const MARGIN: f32 = 1.004;
// Half a block's side, in cells, with room for rounding far from the origin.
const HALF_BOX: f32 = 2.05;
// A block that meets more bricks than these is sampled without asking them.
const MOST_BRICKS: f32 = 4096.0;

// The least and the most density of a brick; there is nothing outside.
fn extremes_of(brick: vec3i, sides: vec3i) -> vec2f {
    if any(brick < vec3i(0)) || any(brick >= sides) {
        return vec2f(0.0);
    }
    let entry = entry_of(vec3u(brick));
    if !entry.is_kept {
        return vec2f(0.0);
    }
    return extremes[(entry.slot.z * bricks.slots.y + entry.slot.y) * bricks.slots.x + entry.slot.x];
}

// Whether noise at its strongest leaves the surface away from a place of such a density. The field with noise is told
// in `field.wgsl`.
fn surely_outside(density: f32) -> bool {
    let share = min(MARGIN * density / recipe.threshold, 1.0);
    return share + recipe.noise_amplitude * share * (2.0 - share) < 1.0;
}

fn state_of(block: u32) -> u32 {
    let cell_m = lattice.cell_m;
    let middle = point_place(kept_place(block) * BLOCK, cell_m) + 0.5 * f32(BLOCK) * cell_m;
    let axes = bricks.voxel_from_world;
    let reach = HALF_BOX * cell_m * (abs(axes[0].xyz) + abs(axes[1].xyz) + abs(axes[2].xyz));
    let at = cell_of(middle);
    let sides = vec3i(bricks.nodes * NODE);
    let low = vec3i(clamp(floor((at - reach) / f32(BRICK)), vec3f(-1.0), vec3f(sides)));
    let high = vec3i(clamp(floor((at + reach) / f32(BRICK)), vec3f(-1.0), vec3f(sides)));
    let size = vec3f(high - low + 1);
    if size.x * size.y * size.z > MOST_BRICKS {
        return ACTIVE;
    }
    var ends = extremes_of(low, sides);
    for (var z = low.z; z <= high.z; z++) {
        for (var y = low.y; y <= high.y; y++) {
            for (var x = low.x; x <= high.x; x++) {
                let own = extremes_of(vec3i(x, y, z), sides);
                ends = vec2f(min(ends.x, own.x), max(ends.y, own.y));
            }
        }
    }
    let inside = ends.x > MARGIN * recipe.threshold * (1.0 + recipe.noise_amplitude);
    return select(select(ACTIVE, INSIDE, inside), OUTSIDE, surely_outside(ends.y));
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let block = (group.y * groups.x + group.x) * 256u + lane;
    if block >= recipe.blocks {
        return;
    }
    var state = OUTSIDE;
    if block < lattice.kept * IN_REGION {
        state = state_of(block);
    }
    crossed[block] = u32(state == ACTIVE);
    // Until it has a slot. One for which there is no room counts as outside.
    states[block] = select(state, OUTSIDE, state == ACTIVE);
}
