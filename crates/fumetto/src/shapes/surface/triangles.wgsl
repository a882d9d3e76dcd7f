// Fills every cell with its case's polygons. Four invocations share the cells of a block.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> states: array<u32>;
@group(0) @binding(3) var<storage, read> active_blocks: array<ActiveBlock>;
@group(0) @binding(4) var<storage, read> crossed: array<Crossed>;
@group(0) @binding(5) var<storage, read> polygons: array<vec2u>;
@group(0) @binding(6) var<storage, read> vertex_starts: array<u32>;
@group(0) @binding(7) var<storage, read> triangle_starts: array<u32>;
@group(0) @binding(8) var<storage, read_write> triangles: array<Triangle>;

fn inside_of(state: u32) -> vec2u {
    if state < ACTIVE {
        return vec2u(select(0u, 0xffffffffu, state == INSIDE));
    }
    return crossed[state - ACTIVE].inside;
}

// The vertex on a cell's edge. Edges are numbered `4 · axis + 2 · v + u`, where u and v are the steps that
// lead to the edge's lower end along the next axis and the one after.
fn vertex_of(block: vec3i, slot: u32, cell: vec3u, edge: u32) -> u32 {
    let axis = edge >> 2u;
    var place = cell;
    place[(axis + 1u) % 3u] += edge & 1u;
    place[(axis + 2u) % 3u] += (edge >> 1u) & 1u;
    let beyond = place >> vec3u(2u);
    let corner = beyond.x | (beyond.y << 1u) | (beyond.z << 2u);
    var owner = slot;
    if corner != 0u {
        let state = state_beyond(block, corner);
        if state < ACTIVE {
            return NOWHERE;
        }
        owner = state - ACTIVE;
    }
    return vertex_starts[owner] + vertices_before(crossed[owner], axis, local_number(place & vec3u(3u)));
}

fn fill(block: vec3i, slot: u32, cell: u32, filling: vec2u, first: u32) {
    for (var index = 0u; index < triangles_in(filling); index++) {
        if first + index >= recipe.triangles {
            return;
        }
        let place = local_place(cell);
        let ends = vec3u(
            vertex_of(block, slot, place, edge_of(filling, 3u * index)),
            vertex_of(block, slot, place, edge_of(filling, 3u * index + 1u)),
            vertex_of(block, slot, place, edge_of(filling, 3u * index + 2u)),
        );
        // One whose vertices were left out covers nothing.
        let whole = all(ends < vec3u(recipe.vertices));
        triangles[first + index] = Triangle(select(vec3u(0u), ends, whole) + recipe.first_vertex, recipe.part);
    }
}

@compute @workgroup_size(32)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = (group.y * groups.x + group.x) * 8u + lane / 4u;
    if slot >= lattice.active_blocks {
        return;
    }
    let block = active_blocks[slot].place;
    let own = crossed[slot];
    let filled = own.ones | own.twos | own.fours;
    let count = bits_of(filled);
    if count == 0u {
        return;
    }
    let corners = corners_of(array(
        own.inside,
        inside_of(state_beyond(block, 1u)),
        inside_of(state_beyond(block, 2u)),
        inside_of(state_beyond(block, 3u)),
        inside_of(state_beyond(block, 4u)),
        inside_of(state_beyond(block, 5u)),
        inside_of(state_beyond(block, 6u)),
        inside_of(state_beyond(block, 7u)),
    ));
    for (var index = lane % 4u; index < count; index += 4u) {
        let cell = nth_point(filled, index);
        let first = triangle_starts[slot] + triangles_before(own, cell);
        fill(block, slot, cell, polygons[case_of(corners, cell)], first);
    }
}
