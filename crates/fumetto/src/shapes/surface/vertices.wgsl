// Puts a vertex where the surface crosses a lattice edge: eight at once, by a few steps of Newton's method from
// the middles of their edges. Those that do not get there are looked for with care (`crossing.wgsl`).
//
// Two invocations share the vertices of a block, of which most have less than sixteen.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<Blob>;
@group(0) @binding(3) var<storage, read> starts: array<u32>;
@group(0) @binding(4) var<storage, read> entries: array<u32>;
@group(0) @binding(5) var<storage, read> active_blocks: array<ActiveBlock>;
@group(0) @binding(6) var<storage, read> crossed: array<Crossed>;
@group(0) @binding(7) var<storage, read> vertex_starts: array<u32>;
@group(0) @binding(8) var<storage, read_write> vertices: array<Vertex>;

// A first step may lead so far beyond the ends of an edge, in edges: it comes from a slope that changes.
const BEYOND: f32 = 0.25;
// A step of so little of a cell is the last. It leaves an error of its square, but the normal is that of where it
// began.
const SHORT: f32 = 1.5e-4;
// Steps after the first; most are there after two.
const MORE_STEPS: u32 = 3u;

// Edges of one block, and where they are.
struct Edges {
    starts: Four,
    // One cell along x, y or z.
    along: Four,
}

// What was found on them.
struct Found {
    places: Four,
    // Where the last step began.
    fields: Fields,
    // Whether the first step led along the edge.
    led: vec4<bool>,
    // Whether the last step was short: the error that is left is about its square.
    there: vec4<bool>,
}

fn edge_of_vertex(block: Crossed, corner: vec3i, index: u32) -> Edge {
    var axis = 0u;
    var left = index;
    var points = block.x;
    if left >= bits_of(block.x) {
        left -= bits_of(block.x);
        axis = 1u;
        points = block.y;
        if left >= bits_of(block.y) {
            left -= bits_of(block.y);
            axis = 2u;
            points = block.z;
        }
    }
    let point = nth_point(points, left);
    let start = point_place(corner + vec3i(local_place(point)), lattice.cell_m);
    let along = vec3f(vec3u(axis) == vec3u(0u, 1u, 2u)) * lattice.cell_m;
    return Edge(start, along, has(block.inside, point) == 1u);
}

// Four edges from the `first` on; the last stands in for those that there are not.
fn edges_from(block: Crossed, corner: vec3i, first: u32) -> Edges {
    let last = vertices_of(block) - 1u;
    let a = edge_of_vertex(block, corner, min(first, last));
    let b = edge_of_vertex(block, corner, min(first + 1u, last));
    let c = edge_of_vertex(block, corner, min(first + 2u, last));
    let d = edge_of_vertex(block, corner, min(first + 3u, last));
    let starts = transpose(mat4x3f(a.start, b.start, c.start, d.start));
    let along = transpose(mat4x3f(a.along, b.along, c.along, d.along));
    return Edges(Four(starts[0], starts[1], starts[2]), Four(along[0], along[1], along[2]));
}

fn fields_at(places: array<Four, 2>, list: vec2u) -> array<Fields, 2> {
    var low = no_fields();
    var high = no_fields();
    for (var at = list.x; at < list.y; at++) {
        let blob = blobs[entries[at]];
        low = added(low, blob, places[0]);
        high = added(high, blob, places[1]);
    }
    return array(fields_of(low, places[0]), fields_of(high, places[1]));
}

fn middles(edges: Edges) -> Four {
    return plus(edges.starts, vec4f(0.5), edges.along);
}

// From the middles to where slopes lead along the edges; and there away from their ends, within the tangent
// planes.
fn first_step(edges: Edges, fields: Fields) -> Found {
    let slopes = dots(fields.slope, edges.along);
    let steep = abs(slopes) > vec4f(FLAT);
    let at = 0.5 - fields.value / select(vec4f(1.0), slopes, steep);
    let led = steep & (at > vec4f(-BEYOND)) & (at < vec4f(1.0 + BEYOND));
    let crossing = clamp(select(vec4f(0.5), at, led), vec4f(0.0), vec4f(1.0));
    let away = clamp(crossing, vec4f(CLEAR), vec4f(1.0 - CLEAR)) - crossing;
    let squares = max(dots(fields.slope, fields.slope), vec4f(FLAT));
    let places = plus(edges.starts, crossing + away, edges.along);
    return Found(plus(places, -away * slopes / squares, fields.slope), fields, led, vec4<bool>());
}

// Back to the surface, along gradients.
fn next_step(edges: Edges, found: Found, fields: Fields) -> Found {
    let back = steps_to_surface(fields, CLEAR * lattice.cell_m);
    let places = plus(found.places, vec4f(1.0), back);
    let off = plus(places, vec4f(-1.0), middles(edges));
    let square = lattice.cell_m * lattice.cell_m;
    let short = dots(back, back) < vec4f(SHORT * SHORT * square);
    let around = dots(off, off) < vec4f(AROUND * AROUND * square);
    let steep = dots(fields.slope, fields.slope) > vec4f(FLAT);
    return Found(places, fields, found.led, found.led & short & around & steep);
}

// Writes four vertices, or as many of them as there are before the `end`-th.
fn write(block: Crossed, corner: vec3i, list: vec2u, found: Found, numbers: vec3u) {
    for (var index = 0u; index < 4u; index++) {
        let number = numbers.x + numbers.y + index;
        if number >= numbers.z {
            return;
        }
        var sample = Sample(one_of(found.places, index), vec4f(one_of(found.fields.slope, index), 0.0));
        if !found.there[index] {
            let edge = edge_of_vertex(block, corner, numbers.y + index);
            let near = near(edge.start + 0.5 * edge.along, AROUND * lattice.cell_m, list);
            sample = surface_near(edge, near);
            sample.field = vec4f(outward(sample.field, edge), 0.0);
        } else {
            sample.field = -normalize(sample.field);
        }
        vertices[number] = Vertex(sample.place, octahedral_packed(sample.field.xyz));
    }
}

@compute @workgroup_size(16)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = (group.y * groups.x + group.x) * 8u + lane / 2u;
    if slot >= lattice.active_blocks {
        return;
    }
    let active_block = active_blocks[slot];
    let list = vec2u(starts[active_block.number], starts[active_block.number + 1u]);
    let corner = active_block.place * BLOCK;
    let block = crossed[slot];
    let count = vertices_of(block);
    let before = vertex_starts[slot];
    let end = min(before + count, recipe.vertices);
    for (var first = 8u * (lane % 2u); first < count; first += 16u) {
        let low = edges_from(block, corner, first);
        let high = edges_from(block, corner, first + 4u);
        let at_middles = fields_at(array(middles(low), middles(high)), list);
        var found_low = first_step(low, at_middles[0]);
        var found_high = first_step(high, at_middles[1]);
        for (var step = 0u; step < MORE_STEPS; step++) {
            let fields = fields_at(array(found_low.places, found_high.places), list);
            found_low = next_step(low, found_low, fields[0]);
            found_high = next_step(high, found_high, fields[1]);
            if all(found_low.there & found_high.there) {
                break;
            }
        }
        write(block, corner, list, found_low, vec3u(before, first, end));
        write(block, corner, list, found_high, vec3u(before, first + 4u, end));
    }
}
