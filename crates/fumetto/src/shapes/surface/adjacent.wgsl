// Finds for each edge of each triangle the triangle beyond, by which shadow volumes know where they end.
//
// No search is needed. Of two triangles that share an edge, either both are of one cell, or the edge lies in
// the face between two cells: diagonals of polygons never do (see `polygons.rs`). The chunks of a block share its
// cells.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> states: array<u32>;
@group(0) @binding(3) var<storage, read> active_blocks: array<ActiveBlock>;
@group(0) @binding(4) var<storage, read> crossed: array<PackedCrossed>;
@group(0) @binding(5) var<storage, read> polygons: array<vec2u>;
// How many vertices, triangles and chunks there are before each block.
@group(0) @binding(6) var<storage, read> mesh_starts: array<vec4u>;
// Three for each triangle, numbered as triangles are: beyond the edges from its first corner to the second, from
// the second to the third, and back.
@group(0) @binding(7) var<storage, read_write> adjacent: array<u32>;

// A cell, and the block that keeps it.
struct Cell {
    slot: u32,
    number: u32,
    // Its polygons.
    filling: vec2u,
}

// State of the block in which a place is, counted from the first cell of `block`.
fn state_at(grid: Grid, block: vec3i, place: vec3i) -> u32 {
    let number = block_number(grid, block + (place >> vec3u(2u)));
    if number == NOWHERE {
        return OUTSIDE;
    }
    return states[number];
}

fn inside_at(grid: Grid, block: vec3i, place: vec3i) -> u32 {
    let state = state_at(grid, block, place);
    if state < ACTIVE {
        return state;
    }
    return has(crossed[state - ACTIVE].inside_x.xy, local_number(vec3u(place & vec3i(3))));
}

fn cell_at(grid: Grid, block: vec3i, place: vec3i) -> Cell {
    let state = state_at(grid, block, place);
    if state < ACTIVE {
        return Cell(NOWHERE, 0u, vec2u(0u));
    }
    var corners = 0u;
    for (var corner = 0u; corner < 8u; corner++) {
        let step = vec3i((vec3u(corner) >> vec3u(0u, 1u, 2u)) & vec3u(1u));
        corners |= inside_at(grid, block, place + step) << corner;
    }
    return Cell(state - ACTIVE, local_number(vec3u(place & vec3i(3))), polygons[corners]);
}

// On which side of the cell an edge lies along an axis, 0 or 1; 2 where it runs along it.
fn side_of(edge: u32, axis: u32) -> u32 {
    let bit = (axis + 5u - (edge >> 2u)) % 3u;
    return select((edge >> bit) & 1u, 2u, bit == 2u);
}

// The same edge on the cell's other side along an axis.
fn opposite(edge: u32, axis: u32) -> u32 {
    return edge ^ (1u << ((axis + 5u - (edge >> 2u)) % 3u));
}

fn first_triangle(cell: Cell) -> u32 {
    return mesh_starts[cell.slot].y + triangles_before(unpacked_crossed(crossed[cell.slot]), cell.number);
}

// The number of the cell's triangle that runs from one edge of the cell to another.
fn triangle_along(cell: Cell, start: u32, end: u32) -> u32 {
    if cell.slot == NOWHERE {
        return NOWHERE;
    }
    let filling = cell.filling;
    for (var index = 0u; index < triangles_in(filling); index++) {
        for (var corner = 0u; corner < 3u; corner++) {
            let next = select(corner + 1u, 0u, corner == 2u);
            if edge_of(filling, 3u * index + corner) == start && edge_of(filling, 3u * index + next) == end {
                return first_triangle(cell) + index;
            }
        }
    }
    return NOWHERE;
}

// The number of the triangle that runs against an edge of one in the cell at `place`.
fn triangle_beyond(grid: Grid, cell: Cell, block: vec3i, place: vec3i, edge: vec2u) -> u32 {
    let start = edge.x;
    let end = edge.y;
    for (var axis = 0u; axis < 3u; axis++) {
        let side = side_of(start, axis);
        if side != 2u && side == side_of(end, axis) {
            var beyond = place;
            beyond[axis] += 2 * i32(side) - 1;
            return triangle_along(cell_at(grid, block, beyond), opposite(end, axis), opposite(start, axis));
        }
    }
    return triangle_along(cell, end, start);
}

fn note(grid: Grid, cell: Cell, block: vec3i, place: vec3i) {
    let first = first_triangle(cell);
    for (var index = 0u; index < triangles_in(cell.filling); index++) {
        if first + index >= recipe.triangles {
            return;
        }
        for (var corner = 0u; corner < 3u; corner++) {
            let next = select(corner + 1u, 0u, corner == 2u);
            let start = edge_of(cell.filling, 3u * index + corner);
            let end = edge_of(cell.filling, 3u * index + next);
            let beyond = triangle_beyond(grid, cell, block, place, vec2u(start, end));
            adjacent[3u * (first + index) + corner] = select(NOWHERE, beyond, beyond < recipe.triangles);
        }
    }
}

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let grid = grid();
    let blocks = lattice.active_blocks;
    let number = (group.y * groups.x + group.x) * 64u + lane;
    if number >= mesh_starts[recipe.active_blocks].z {
        return;
    }
    let chunk = chunk_at(number, blocks);
    let block = active_blocks[chunk.slot].place;
    let own = unpacked_crossed(crossed[chunk.slot]);
    let filled = own.ones | own.twos | own.fours;
    for (var index = chunk.index; index < bits_of(filled); index += chunk.count) {
        let place = vec3i(local_place(nth_point(filled, index)));
        note(grid, cell_at(grid, block, place), block, place);
    }
}
