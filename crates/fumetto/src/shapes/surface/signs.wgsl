// Asks of every point of the active blocks whether it is inside. Only here: all that is decided later
// about how the surface hangs together is decided by these bits.
//
// Lists are in no order here, and a sum of floats depends on it: densities are rounded down to units, so small
// that these and their sums are whole numbers that floats hold exactly.
//
// An invocation asks the sixteen points of a layer: what it reads of a particle serves them all. Four
// invocations ask a block, a workgroup eight blocks.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<Blob>;
@group(0) @binding(3) var<storage, read> starts: array<u32>;
@group(0) @binding(4) var<storage, read> entries: array<u32>;
@group(0) @binding(5) var<storage, read> active_blocks: array<ActiveBlock>;
// A bit for each point of a layer.
@group(0) @binding(6) var<storage, read_write> signs: array<u32>;

// Densities at the points of a layer, in units: x in the vectors, y by row.
struct Layer {
    row_0: vec4f,
    row_1: vec4f,
    row_2: vec4f,
    row_3: vec4f,
}

// A point of more units is inside, whatever noise does.
const INSIDE_UNITS: f32 = 4194304.0;
// No sum counts for more: beyond twice this, floats have no ones.
const FULL: vec4f = vec4f(2.0 * INSIDE_UNITS);

// The sum with equation 2 for one particle at four points, from squared distances. Its mass is in units.
fn plus(sum: vec4f, mass: f32, inverse_square: f32, squares: vec4f) -> vec4f {
    let fall = max(1.0 - squares * inverse_square, vec4f(0.0));
    return min(sum + floor(mass * fall * fall), FULL);
}

fn is_inside(layer: Layer) -> bool {
    let least = min(min(layer.row_0, layer.row_1), min(layer.row_2, layer.row_3));
    return all(least > vec4f(INSIDE_UNITS));
}

fn unit() -> f32 {
    return recipe.threshold * (1.0 + recipe.noise_amplitude) / INSIDE_UNITS;
}

fn layer_at(first: vec3i, list: vec2u) -> Layer {
    let along_x = vec4f(vec4i(first.x) + vec4i(0, 1, 2, 3)) * lattice.cell_m;
    let along_y = vec4f(vec4i(first.y) + vec4i(0, 1, 2, 3)) * lattice.cell_m;
    let z = f32(first.z) * lattice.cell_m;
    let units = 1.0 / unit();
    var layer = Layer(vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0));
    for (var at = list.x; at < list.y; at++) {
        let blob = blobs[entries[at]];
        let x = along_x - blob.center.x;
        let y = along_y - blob.center.y;
        let across = y * y + (z - blob.center.z) * (z - blob.center.z);
        let xx = x * x;
        let mass = blob.mass * units;
        layer.row_0 = plus(layer.row_0, mass, blob.inverse_square, xx + across.x);
        layer.row_1 = plus(layer.row_1, mass, blob.inverse_square, xx + across.y);
        layer.row_2 = plus(layer.row_2, mass, blob.inverse_square, xx + across.z);
        layer.row_3 = plus(layer.row_3, mass, blob.inverse_square, xx + across.w);
        if is_inside(layer) {
            break;
        }
    }
    return layer;
}

// Bits of the points of a row that begins at `first`.
fn insides(first: vec3i, densities: vec4f) -> u32 {
    if recipe.noise_amplitude == 0.0 {
        return dot(vec4u(densities > vec4f(INSIDE_UNITS)), vec4u(1u, 2u, 4u, 8u));
    }
    var bits = 0u;
    for (var point = 0u; point < 4u; point++) {
        let place = point_place(first + vec3i(i32(point), 0, 0), lattice.cell_m);
        let field = field_of(vec4f(vec3f(0.0), densities[point] * unit()), place);
        bits |= select(0u, 1u << point, field.w > 0.0);
    }
    return bits;
}

@compute @workgroup_size(32)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = (group.y * groups.x + group.x) * 8u + lane / 4u;
    if slot >= lattice.active_blocks {
        return;
    }
    let block = active_blocks[slot];
    let first = block.place * BLOCK + vec3i(0, 0, i32(lane % 4u));
    let layer = layer_at(first, vec2u(starts[block.number], starts[block.number + 1u]));
    signs[4u * slot + lane % 4u] = insides(first, layer.row_0)
        | (insides(first + vec3i(0, 1, 0), layer.row_1) << 4u)
        | (insides(first + vec3i(0, 2, 0), layer.row_2) << 8u)
        | (insides(first + vec3i(0, 3, 0), layer.row_3) << 12u);
}
