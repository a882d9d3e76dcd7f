// Puts a vertex where the surface crosses a lattice edge.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<Blob>;
@group(0) @binding(3) var<storage, read> starts: array<u32>;
@group(0) @binding(4) var<storage, read> entries: array<u32>;
@group(0) @binding(5) var<storage, read> active_blocks: array<u32>;
@group(0) @binding(6) var<storage, read> cells: array<u32>;
@group(0) @binding(7) var<storage, read> vertex_starts: array<u32>;
@group(0) @binding(8) var<storage, read_write> vertices: array<Vertex>;

// Newton converges in three or four steps; where it can only halve, so many leave 1/1024 of a cell.
const STEPS: u32 = 10u;
// A step of so little of a cell is the last: the next one's error is its square.
const CONVERGED: f32 = 1e-3;
// A vertex keeps so much of an edge from its ends: vertices around a lattice point that the surface
// passes closely would else be the corners of slivers. On a sphere, angles of less than 20° then go from
// one triangle in four to one in a hundred.
const CLEAR: f32 = 0.4;
// Gradients below this lead nowhere.
const FLAT: f32 = 1e-20;

// How far along the edge the field is zero: Newton's method, kept within what is known to hold the root.
fn crossing(start: vec3f, along: vec3f, inside: bool, list: vec2u) -> f32 {
    var low = 0.0;
    var high = 1.0;
    var at = 0.5;
    for (var step = 0u; step < STEPS; step++) {
        let field = field_at(start + at * along, list);
        if (field.w > 0.0) == inside {
            low = at;
        } else {
            high = at;
        }
        let slope = dot(field.xyz, along);
        var next = 0.5 * (low + high);
        if abs(slope) > FLAT {
            let newton = at - field.w / slope;
            if abs(newton - at) < CONVERGED {
                return clamp(newton, 0.0, 1.0);
            }
            next = select(next, newton, newton > low && newton < high);
        }
        at = next;
    }
    return at;
}

// The step from a place to the surface, as far as field and gradient there tell; at most `most` long.
fn step_to_surface(field: vec4f, most: f32) -> vec3f {
    let steepness = length(field.xyz);
    if steepness <= FLAT {
        return vec3f(0.0);
    }
    return field.xyz / steepness * clamp(-field.w / steepness, -most, most);
}

struct Sample {
    place: vec3f,
    field: vec4f,
}

// Away from the edge's end, within the surface's tangent plane, and from there back to the surface.
fn slid(crossed: Sample, away: vec3f, list: vec2u) -> Sample {
    let normal = crossed.field.xyz / length(crossed.field.xyz);
    var place = crossed.place + away - normal * dot(normal, away);
    for (var step = 0u; step < 2u; step++) {
        place += step_to_surface(field_at(place, list), length(away));
    }
    return Sample(place, field_at(place, list));
}

fn surface_near(start: vec3f, along: vec3f, inside: bool, list: vec2u) -> Sample {
    let at = crossing(start, along, inside, list);
    let place = start + at * along;
    let crossed = Sample(place, field_at(place, list));
    let away = clamp(at, CLEAR, 1.0 - CLEAR) - at;
    if away == 0.0 || length(crossed.field.xyz) <= FLAT {
        return crossed;
    }
    let slid = slid(crossed, away * along, list);
    // Not where the surface bends so much that it was missed.
    let missed = length(step_to_surface(slid.field, lattice.cell_m));
    let found = missed < CONVERGED * lattice.cell_m && length(slid.field.xyz) > FLAT;
    if found {
        return slid;
    }
    return crossed;
}

fn outward(field: vec4f, along: vec3f, inside: bool) -> vec3f {
    let steepness = length(field.xyz);
    if steepness > FLAT {
        return -field.xyz / steepness;
    }
    return select(-1.0, 1.0, inside) * along / lattice.cell_m;
}

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = group.y * groups.x + group.x;
    if slot >= lattice.active_blocks {
        return;
    }
    let block = active_blocks[slot];
    let list = vec2u(starts[block], starts[block + 1u]);
    let corner = (lattice.first + block_place(lattice.blocks, block)) * BLOCK;
    let start = point_place(corner + vec3i(local_place(lane)), lattice.cell_m);
    let cell = cells[slot * 64u + lane];
    let inside = (cell_corners(cell) & 1u) == 1u;
    var number = vertex_starts[slot] + cell_vertices_before(cell);
    for (var axis = 0u; axis < 3u; axis++) {
        if (own_crossings(cell_corners(cell)) & (1u << axis)) != 0u {
            if number < recipe.vertices {
                var along = vec3f(0.0);
                along[axis] = lattice.cell_m;
                let found = surface_near(start, along, inside, list);
                let normal = octahedral_packed(outward(found.field, along, inside));
                vertices[number] = Vertex(found.place, normal);
            }
            number++;
        }
    }
}
