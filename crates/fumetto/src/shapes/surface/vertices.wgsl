// Puts a vertex where the surface crosses a lattice edge: eight at once, by a few steps of Newton's method from
// the middles of their edges. Those that do not get there at once are left for `careful.wgsl`: a processor that
// draws goes all ways that a kernel has, even where no invocation does.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<PackedBlob>;
@group(0) @binding(3) var<storage, read> entries: array<u32>;
@group(0) @binding(4) var<storage, read> active_blocks: array<ActiveBlock>;
@group(0) @binding(5) var<storage, read> crossed: array<PackedCrossed>;
// How many vertices, triangles and chunks there are before each block.
@group(0) @binding(6) var<storage, read> mesh_starts: array<vec4u>;
@group(0) @binding(7) var<storage, read_write> hard: Hard;
@group(0) @binding(8) var<storage, read_write> vertices: array<Vertex>;

// A first step may lead so far beyond the ends of an edge, in edges: it comes from a slope that changes.
const BEYOND: f32 = 0.25;
// The second step is the last if it is as short as this, in cells. It leaves an error of its square, but the normal is
// that of where it began.
const SHORT: f32 = 0.01;

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

// Four edges from the `first` on; the last stands in for those that there are not.
fn edges_from(skin: Skin, first: u32, cell_m: f32) -> Edges {
    let last = vertices_of(skin.crossed) - 1u;
    let a = edge_of_vertex(skin, min(first, last), cell_m);
    let b = edge_of_vertex(skin, min(first + 1u, last), cell_m);
    let c = edge_of_vertex(skin, min(first + 2u, last), cell_m);
    let d = edge_of_vertex(skin, min(first + 3u, last), cell_m);
    let starts = transpose(mat4x3f(a.start, b.start, c.start, d.start));
    let along = transpose(mat4x3f(a.along, b.along, c.along, d.along));
    return Edges(Four(starts[0], starts[1], starts[2]), Four(along[0], along[1], along[2]));
}

fn fields_at(places: array<Four, 2>, list: vec2u, units: Units) -> array<Fields, 2> {
    let per = Units(units.cell_m, 1.0 / units.density, 1.0 / units.slope);
    var low = Sums();
    var high = Sums();
    for (var at = list.x; at < list.y; at++) {
        let blob = unpacked(blobs[entries[at]]);
        low = added(low, blob, places[0], per);
        high = added(high, blob, places[1], per);
    }
    return array(fields_of(low, places[0], units), fields_of(high, places[1], units));
}

fn middles(edges: Edges) -> Four {
    return plus(edges.starts, vec4f(0.5), edges.along);
}

// From the middles to where slopes lead along the edges; and there away from their ends, within the tangent
// planes.
fn first_step(edges: Edges, fields: Fields, threshold: f32) -> Found {
    let slopes = dots(fields.slope, edges.along);
    let steep = abs(slopes) > vec4f(FLAT);
    let at = 0.5 - rises(fields.value, threshold) / select(vec4f(1.0), slopes, steep);
    let led = steep & (at > vec4f(-BEYOND)) & (at < vec4f(1.0 + BEYOND));
    let crossing = clamp(select(vec4f(0.5), at, led), vec4f(0.0), vec4f(1.0));
    let away = clamp(crossing, vec4f(CLEAR), vec4f(1.0 - CLEAR)) - crossing;
    let squares = max(dots(fields.slope, fields.slope), vec4f(FLAT));
    let places = plus(edges.starts, crossing + away, edges.along);
    return Found(plus(places, -away * slopes / squares, fields.slope), fields, led, vec4<bool>());
}

// Back to the surface, along gradients.
fn next_step(edges: Edges, found: Found, fields: Fields, threshold: f32, cell_m: f32) -> Found {
    let back = steps_to_surface(fields, threshold, CLEAR * cell_m);
    let places = plus(found.places, vec4f(1.0), back);
    let off = plus(places, vec4f(-1.0), middles(edges));
    let square = cell_m * cell_m;
    let short = dots(back, back) < vec4f(SHORT * SHORT * square);
    let around = dots(off, off) < vec4f(AROUND * AROUND * square);
    let steep = dots(fields.slope, fields.slope) > vec4f(FLAT);
    return Found(places, fields, found.led, found.led & short & around & steep);
}

// Writes four vertices from the block's `first` on, or as many of them as there are. `room` has the number of the
// block's first vertex, and of what is beyond its last.
fn write(slot: u32, first: u32, found: Found, room: vec2u) {
    let steep = sqrt(dots(found.fields.slope, found.fields.slope));
    let outward = Four(-found.fields.slope.x / steep, -found.fields.slope.y / steep, -found.fields.slope.z / steep);
    for (var index = 0u; index < 4u; index++) {
        let number = room.x + first + index;
        if number < room.y {
            if found.there[index] {
                vertices[number] = Vertex(one_of(found.places, index), octahedral_packed(one_of(outward, index)));
            } else {
                leave(slot, first + index);
            }
        }
    }
}

// Notes a vertex for `careful.wgsl`. In any order: each has its place already.
fn leave(slot: u32, index: u32) {
    let at = atomicAdd(&hard.count, 1u);
    hard.vertices[at] = (slot << 8u) | index;
    if at % 64u == 0u {
        atomicAdd(&hard.groups_x, 1u);
    }
}

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let units = units();
    let threshold = recipe.threshold;
    let capacity = recipe.vertices;
    let blocks = lattice.active_blocks;
    let number = (group.y * groups.x + group.x) * 64u + lane;
    if number >= mesh_starts[recipe.active_blocks].z {
        return;
    }
    let chunk = chunk_at(number, blocks);
    let skin = skin_of(chunk.slot);
    let count = vertices_of(skin.crossed);
    if count == 0u {
        return;
    }
    let first = IN_CHUNK * chunk.index;
    let low = edges_from(skin, first, units.cell_m);
    let high = edges_from(skin, first + 4u, units.cell_m);
    let at_middles = fields_at(array(middles(low), middles(high)), skin.list, units);
    let near_low = first_step(low, at_middles[0], threshold);
    let near_high = first_step(high, at_middles[1], threshold);
    let fields = fields_at(array(near_low.places, near_high.places), skin.list, units);
    let found_low = next_step(low, near_low, fields[0], threshold, units.cell_m);
    let found_high = next_step(high, near_high, fields[1], threshold, units.cell_m);
    let room = vec2u(chunk.first_vertex, min(chunk.first_vertex + count, capacity));
    write(chunk.slot, first, found_low, room);
    write(chunk.slot, first + 4u, found_high, room);
}
