// Finds the blocks that the surface can cross, without sampling any: over a block's box each particle's
// density lies between what it is at the farthest and at the nearest place.
//
// Bounds are summed as integers, so that they do not depend on the order of a list.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<PackedBlob>;
@group(0) @binding(3) var<storage, read> starts: array<u32>;
@group(0) @binding(4) var<storage, read> entries: array<u32>;
@group(0) @binding(5) var<storage, read_write> states: array<u32>;
// 1 where the surface may cross the block.
@group(0) @binding(6) var<storage, read_write> crossed: array<u32>;
// The first block of each region that is kept.
@group(0) @binding(7) var<storage, read> kept: array<vec3i>;
// Of `bins.wgsl`; back to none for the next frame.
@group(0) @binding(8) var<storage, read_write> tally: array<u32>;

// What the threshold counts for.
const UNITS: f32 = 4096.0;
// Units that bounds are widened by: more than what rounding loses in a sum of floats.
const MARGIN: u32 = 8u;
// Half a block's side, in cells, with room for rounding far from the origin.
const HALF_BOX: f32 = 2.05;
// No particle counts for more, and no sum: neither overflows.
const MOST_UNITS: f32 = 16777216.0;
const FULL: u32 = 1073741824u;

// What is the same for all blocks, read once.
struct Everywhere {
    cell_m: f32,
    widest_m: f32,
    blocks: u32,
    units_per_mass: f32,
    noise_amplitude: f32,
}

fn units_at(blob: Blob, squared_distance: f32, units_per_mass: f32) -> f32 {
    let fall = max(1.0 - squared_distance * blob.inverse_square, 0.0);
    return min(blob.mass * fall * fall * units_per_mass, MOST_UNITS);
}

// Whether noise at its strongest leaves the surface away from a place of at most so many units. The field
// with noise is told in `field.wgsl`.
fn surely_outside(units: u32, noise_amplitude: f32) -> bool {
    let share = min(f32(units + MARGIN) / UNITS, 1.0);
    return share + noise_amplitude * share * (2.0 - share) < 1.0;
}

fn state_of(everywhere: Everywhere, block: u32) -> u32 {
    let low_corner = point_place(kept_place(block) * BLOCK, everywhere.cell_m);
    let middle = low_corner + 0.5 * f32(BLOCK) * everywhere.cell_m;
    let half_m = HALF_BOX * everywhere.cell_m;
    let inside_units = min(UNITS * (1.0 + everywhere.noise_amplitude), MOST_UNITS);
    // Where none spans a block, none is surely inside.
    let all_are_small = everywhere.widest_m < length(vec3f(half_m));
    var least = 0u;
    var most = 0u;
    let end = starts[block + 1u];
    for (var at = starts[block]; at < end; at++) {
        let blob = unpacked(blobs[entries[at]]);
        let off = abs(blob.center - middle);
        let near = max(off - half_m, vec3f(0.0));
        let far = off + half_m;
        least = min(least + u32(floor(units_at(blob, dot(far, far), everywhere.units_per_mass))), FULL);
        most = min(most + u32(ceil(units_at(blob, dot(near, near), everywhere.units_per_mass))), FULL);
        if least > u32(inside_units) + MARGIN {
            return INSIDE;
        }
        if all_are_small && !surely_outside(most, everywhere.noise_amplitude) {
            return ACTIVE;
        }
    }
    return select(ACTIVE, OUTSIDE, surely_outside(most, everywhere.noise_amplitude));
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let everywhere =
        Everywhere(lattice.cell_m, lattice.widest_m, lattice.kept * IN_REGION, UNITS / recipe.threshold, recipe.noise_amplitude);
    let block = (group.y * groups.x + group.x) * 256u + lane;
    if block >= recipe.blocks {
        return;
    }
    var state = OUTSIDE;
    if block < everywhere.blocks {
        state = state_of(everywhere, block);
    }
    tally[block] = 0u;
    crossed[block] = u32(state == ACTIVE);
    // Until it has a slot. One for which there is no room counts as outside.
    states[block] = select(state, OUTSIDE, state == ACTIVE);
}
