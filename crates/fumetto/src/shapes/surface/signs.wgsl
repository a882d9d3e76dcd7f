// Asks of every point of the active blocks whether it is inside. Only here: all that is decided later
// about how the surface hangs together is decided by these bits.
//
// Densities are rounded down to units, so small that these and their sums are whole numbers that floats hold
// exactly: lists are in no order.
//
// An invocation asks all points of a block: what it reads of a particle serves them all.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<PackedBlob>;
@group(0) @binding(3) var<storage, read> starts: array<u32>;
@group(0) @binding(4) var<storage, read> entries: array<u32>;
@group(0) @binding(5) var<storage, read> active_blocks: array<ActiveBlock>;
// A bit for each point of a block.
@group(0) @binding(6) var<storage, read_write> signs: array<vec2u>;

// Densities at the points of a layer, in units: x in the vectors, y by row.
struct Layer {
    row_0: vec4f,
    row_1: vec4f,
    row_2: vec4f,
    row_3: vec4f,
}

struct Points {
    layer_0: Layer,
    layer_1: Layer,
    layer_2: Layer,
    layer_3: Layer,
}

// Where a block's points lie along each axis.
struct Places {
    x: vec4f,
    y: vec4f,
    z: vec4f,
}

// So many particles of a list are added before it is asked whether more matter.
const AT_ONCE: u32 = 16u;

// Equation 2 for one particle at four points. It is a square: of what the root of the mass is at the particle's
// middle, less so much for the squared distance. Sums beyond what floats hold exactly are inside in any order.
fn plus(sum: vec4f, root: vec4f) -> vec4f {
    let fall = max(root, vec4f(0.0));
    return sum + floor(fall * fall);
}

fn plus_layer(sum: Layer, left: vec4f, x: vec4f) -> Layer {
    return Layer(
        plus(sum.row_0, left.x - x),
        plus(sum.row_1, left.y - x),
        plus(sum.row_2, left.z - x),
        plus(sum.row_3, left.w - x),
    );
}

fn plus_blob(sum: Points, blob: Blob, per_density: f32, places: Places) -> Points {
    let root = sqrt(blob.mass * per_density);
    let steep = root * blob.inverse_square;
    let off = Places(places.x - blob.center.x, places.y - blob.center.y, places.z - blob.center.z);
    let x = steep * off.x * off.x;
    let y = steep * off.y * off.y;
    let left = root - steep * off.z * off.z;
    return Points(
        plus_layer(sum.layer_0, left.x - y, x),
        plus_layer(sum.layer_1, left.y - y, x),
        plus_layer(sum.layer_2, left.z - y, x),
        plus_layer(sum.layer_3, left.w - y, x),
    );
}

fn least(layer: Layer) -> vec4f {
    return min(min(layer.row_0, layer.row_1), min(layer.row_2, layer.row_3));
}

fn all_inside(points: Points) -> bool {
    let upper = min(least(points.layer_2), least(points.layer_3));
    return all(min(min(least(points.layer_0), least(points.layer_1)), upper) > vec4f(INSIDE_UNITS));
}

// Densities at all points, unless they are all inside whatever is left.
fn points_of(list: vec2u, per_density: f32, places: Places) -> Points {
    var points = Points();
    for (var first = list.x; first < list.y && !all_inside(points); first += AT_ONCE) {
        for (var at = first; at < min(first + AT_ONCE, list.y); at++) {
            points = plus_blob(points, unpacked(blobs[entries[at]]), per_density, places);
        }
    }
    return points;
}

fn row_bits(densities: vec4f) -> u32 {
    return dot(vec4u(densities > vec4f(INSIDE_UNITS)), vec4u(1u, 2u, 4u, 8u));
}

fn layer_bits(layer: Layer) -> u32 {
    return row_bits(layer.row_0) | (row_bits(layer.row_1) << 4u) | (row_bits(layer.row_2) << 8u)
        | (row_bits(layer.row_3) << 12u);
}

fn bits_without_noise(points: Points) -> vec2u {
    return vec2u(
        layer_bits(points.layer_0) | (layer_bits(points.layer_1) << 16u),
        layer_bits(points.layer_2) | (layer_bits(points.layer_3) << 16u),
    );
}

fn rows_of(layer: Layer) -> array<vec4f, 4> {
    return array(layer.row_0, layer.row_1, layer.row_2, layer.row_3);
}

fn bits_with_noise(points: Points, first: vec3i, units: Units) -> vec2u {
    var layers =
        array(rows_of(points.layer_0), rows_of(points.layer_1), rows_of(points.layer_2), rows_of(points.layer_3));
    var bits = vec2u(0u);
    for (var point = 0u; point < 64u; point++) {
        let at = local_place(point);
        let density = layers[at.z][at.y][at.x] * units.density;
        let field = field_of(vec4f(vec3f(0.0), density), point_place(first + vec3i(at), units.cell_m));
        bits[point / 32u] |= select(0u, 1u << (point % 32u), field.w > 0.0);
    }
    return bits;
}

@compute @workgroup_size(32)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let units = units();
    let slot = (group.y * groups.x + group.x) * 32u + lane;
    if slot >= lattice.active_blocks {
        return;
    }
    let block = active_blocks[slot];
    let first = block.place * BLOCK;
    let along = vec4i(0, 1, 2, 3);
    let places = Places(
        vec4f(first.x + along) * units.cell_m,
        vec4f(first.y + along) * units.cell_m,
        vec4f(first.z + along) * units.cell_m,
    );
    let points = points_of(vec2u(starts[block.number], starts[block.number + 1u]), 1.0 / units.density, places);
    if NOISY {
        signs[slot] = bits_with_noise(points, first, units);
    } else {
        signs[slot] = bits_without_noise(points);
    }
}
