// Fills every cell with its case's polygons. The chunks of a block share its cells.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> states: array<u32>;
@group(0) @binding(3) var<storage, read> active_blocks: array<ActiveBlock>;
@group(0) @binding(4) var<storage, read> crossed: array<PackedCrossed>;
@group(0) @binding(5) var<storage, read> polygons: array<vec2u>;
// How many vertices, triangles and chunks there are before each block.
@group(0) @binding(6) var<storage, read> mesh_starts: array<vec4u>;
@group(0) @binding(7) var<storage, read_write> triangles: array<Triangle>;

// States of a block and of those beyond its upper faces, by corner number.
var<private> states_around: array<u32, 8>;

// Where the vertices of a block are.
struct Owner {
    first_vertex: u32,
    x: vec2u,
    y: vec2u,
    z: vec2u,
}

// What is the same for all triangles.
struct Mesh {
    part: u32,
    first_vertex: u32,
    // Capacities.
    vertices: u32,
    triangles: u32,
}

fn inside_of(state: u32) -> vec2u {
    if state < ACTIVE {
        return vec2u(select(0u, 0xffffffffu, state == INSIDE));
    }
    return crossed[state - ACTIVE].inside_x.xy;
}

// The vertex on a cell's edge. Edges are numbered `4 · axis + 2 · v + u`, where u and v are the steps that
// lead to the edge's lower end along the next axis and the one after.
fn vertex_of(own: Owner, cell: vec3u, edge: u32) -> u32 {
    let axis = edge >> 2u;
    let u = edge & 1u;
    let v = (edge >> 1u) & 1u;
    let place = cell + select(select(vec3u(u, v, 0u), vec3u(v, 0u, u), axis == 1u), vec3u(0u, u, v), axis == 0u);
    let beyond = place >> vec3u(2u);
    var owner = own;
    if any(beyond != vec3u(0u)) {
        let state = states_around[beyond.x | (beyond.y << 1u) | (beyond.z << 2u)];
        // One that was left out.
        if state < ACTIVE {
            return NOWHERE;
        }
        let slot = state - ACTIVE;
        let block = crossed[slot];
        owner = Owner(mesh_starts[slot].x, block.inside_x.zw, block.y_z.xy, block.y_z.zw);
    }
    // All vertices along earlier axes come first, and along its own those of earlier points.
    let lower = before(local_number(place & vec3u(3u)));
    let x = select(owner.x, owner.x & lower, axis == 0u);
    let y = select(select(vec2u(0u), owner.y, axis == 2u), owner.y & lower, axis == 1u);
    let z = select(vec2u(0u), owner.z & lower, axis == 2u);
    return owner.first_vertex + bits_of(x) + bits_of(y) + bits_of(z);
}

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let grid = grid();
    let mesh = Mesh(recipe.part, recipe.first_vertex, recipe.vertices, recipe.triangles);
    let blocks = lattice.active_blocks;
    let number = (group.y * groups.x + group.x) * 64u + lane;
    if number >= mesh_starts[recipe.active_blocks].z {
        return;
    }
    let chunk = chunk_at(number, blocks);
    let own = unpacked_crossed(crossed[chunk.slot]);
    let filled = own.ones | own.twos | own.fours;
    let place = active_blocks[chunk.slot].place;
    states_around[0] = ACTIVE + chunk.slot;
    for (var corner = 1u; corner < 8u; corner++) {
        states_around[corner] = state_beyond(grid, place, corner);
    }
    let corners = corners_of(array(
        own.inside,
        inside_of(states_around[1]),
        inside_of(states_around[2]),
        inside_of(states_around[3]),
        inside_of(states_around[4]),
        inside_of(states_around[5]),
        inside_of(states_around[6]),
        inside_of(states_around[7]),
    ));
    let owner = Owner(chunk.first_vertex, own.x, own.y, own.z);
    let cells = bits_of(filled);
    var cell = cells * chunk.index / chunk.count;
    let end = cells * (chunk.index + 1u) / chunk.count;
    if cell == end {
        return;
    }
    var point = nth_point(filled, cell);
    var triangle = chunk.first_triangle + triangles_before(own, point);
    var filling = polygons[case_of(corners, point)];
    var index = 0u;
    // One triangle a round, whichever cell it is of: so invocations end together.
    while cell < end && triangle < mesh.triangles {
        let at = local_place(point);
        let ends = vec3u(
            vertex_of(owner, at, edge_of(filling, 3u * index)),
            vertex_of(owner, at, edge_of(filling, 3u * index + 1u)),
            vertex_of(owner, at, edge_of(filling, 3u * index + 2u)),
        );
        // One whose vertices were left out covers nothing.
        let whole = all(ends < vec3u(mesh.vertices));
        triangles[triangle] = Triangle(select(vec3u(0u), ends, whole) + mesh.first_vertex, mesh.part);
        triangle++;
        index++;
        if index == triangles_in(filling) {
            index = 0u;
            cell++;
            point = next_point(filled, point);
            filling = polygons[case_of(corners, point)];
        }
    }
}
