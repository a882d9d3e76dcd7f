// Fills every cell with its case's polygons.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> states: array<u32>;
@group(0) @binding(3) var<storage, read> active_blocks: array<u32>;
@group(0) @binding(4) var<storage, read> cells: array<u32>;
@group(0) @binding(5) var<storage, read> polygons: array<vec2u>;
@group(0) @binding(6) var<storage, read> vertex_starts: array<u32>;
@group(0) @binding(7) var<storage, read> triangle_starts: array<u32>;
@group(0) @binding(8) var<storage, read_write> triangles: array<Triangle>;

// The vertex on a cell's edge. Edges are numbered `4 · axis + 2 · v + u`, where u and v are the steps that
// lead to the edge's lower end along the next axis and the one after.
fn vertex_of(cell: vec3u, edge: u32) -> u32 {
    let axis = edge >> 2u;
    var place = cell;
    place[(axis + 1u) % 3u] += edge & 1u;
    place[(axis + 2u) % 3u] += (edge >> 1u) & 1u;
    let state = neighbours[neighbour_of(place)];
    if state < ACTIVE {
        return NOWHERE;
    }
    let slot = state - ACTIVE;
    let owner = cells[slot * 64u + local_number(place & vec3u(3u))];
    let before = countOneBits(own_crossings(cell_corners(owner)) & ((1u << axis) - 1u));
    return vertex_starts[slot] + cell_vertices_before(owner) + before;
}

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = group.y * groups.x + group.x;
    if slot >= lattice.active_blocks {
        return;
    }
    meet_neighbours(active_blocks[slot], lane);
    workgroupBarrier();
    let cell = cells[slot * 64u + lane];
    let filling = polygons[cell_corners(cell)];
    let first = triangle_starts[slot] + cell_triangles_before(cell);
    for (var index = 0u; index < triangles_of(filling); index++) {
        if first + index >= recipe.triangles {
            return;
        }
        var ends = vec3u(0u);
        for (var corner = 0u; corner < 3u; corner++) {
            ends[corner] = vertex_of(local_place(lane), edge_of(filling, 3u * index + corner));
        }
        // One whose vertices were left out covers nothing.
        let whole = all(ends < vec3u(recipe.vertices));
        triangles[first + index] = Triangle(select(vec3u(0u), ends, whole) + recipe.first_vertex, recipe.part);
    }
}
