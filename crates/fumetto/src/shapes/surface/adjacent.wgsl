// Finds for each edge of each triangle the triangle beyond, by which shadow volumes know where they end.
//
// No search is needed. Of two triangles that share an edge, either both are of one cell, or the edge lies in
// the face between two cells: diagonals of polygons never do (see `polygons.rs`).

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> states: array<u32>;
@group(0) @binding(3) var<storage, read> active_blocks: array<u32>;
@group(0) @binding(4) var<storage, read> cells: array<u32>;
@group(0) @binding(5) var<storage, read> polygons: array<vec2u>;
@group(0) @binding(6) var<storage, read> triangle_starts: array<u32>;
// Three for each triangle, numbered as triangles are: beyond the edges from its first corner to the second, from
// the second to the third, and back.
@group(0) @binding(7) var<storage, read_write> adjacent: array<u32>;

// States of the block itself, and of those beyond its lower and upper faces along x, y and z.
var<workgroup> around: array<u32, 7>;

// A cell and where it is kept.
struct Cell {
    slot: u32,
    word: u32,
}

// The cell at a place that is at most one cell outside of the block, along one axis.
fn cell_at(place: vec3i) -> Cell {
    let beyond = place >> vec3u(2u);
    let axes = abs(beyond);
    let face = 2 * (axes.y + 2 * axes.z) + (beyond.x + beyond.y + beyond.z + 1) / 2 + 1;
    let state = around[select(0, face, any(axes != vec3i(0)))];
    if state < ACTIVE {
        return Cell(NOWHERE, 0u);
    }
    let slot = state - ACTIVE;
    return Cell(slot, cells[slot * 64u + local_number(vec3u(place & vec3i(3)))]);
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

// The number of the cell's triangle that runs from one edge of the cell to another.
fn triangle_along(cell: Cell, start: u32, end: u32) -> u32 {
    if cell.slot == NOWHERE {
        return NOWHERE;
    }
    let filling = polygons[cell_corners(cell.word)];
    for (var index = 0u; index < triangles_of(filling); index++) {
        for (var corner = 0u; corner < 3u; corner++) {
            let next = select(corner + 1u, 0u, corner == 2u);
            if edge_of(filling, 3u * index + corner) == start && edge_of(filling, 3u * index + next) == end {
                return triangle_starts[cell.slot] + cell_triangles_before(cell.word) + index;
            }
        }
    }
    return NOWHERE;
}

// The number of the triangle that runs against an edge of one in the cell at `place`.
fn triangle_beyond(cell: Cell, place: vec3i, start: u32, end: u32) -> u32 {
    for (var axis = 0u; axis < 3u; axis++) {
        let side = side_of(start, axis);
        if side != 2u && side == side_of(end, axis) {
            var beyond = place;
            beyond[axis] += 2 * i32(side) - 1;
            return triangle_along(cell_at(beyond), opposite(end, axis), opposite(start, axis));
        }
    }
    return triangle_along(cell, end, start);
}

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = group.y * groups.x + group.x;
    if slot >= lattice.active_blocks {
        return;
    }
    if lane < 7u {
        var step = vec3i(0);
        if lane > 0u {
            step[(lane - 1u) / 2u] = select(-1, 1, lane % 2u == 0u);
        }
        let block = block_number(lattice.blocks, block_place(lattice.blocks, active_blocks[slot]) + step);
        var state = OUTSIDE;
        if block != NOWHERE {
            state = states[block];
        }
        around[lane] = state;
    }
    workgroupBarrier();
    let cell = Cell(slot, cells[slot * 64u + lane]);
    let filling = polygons[cell_corners(cell.word)];
    let first = triangle_starts[slot] + cell_triangles_before(cell.word);
    for (var index = 0u; index < triangles_of(filling); index++) {
        if first + index >= recipe.triangles {
            return;
        }
        for (var corner = 0u; corner < 3u; corner++) {
            let next = select(corner + 1u, 0u, corner == 2u);
            let start = edge_of(filling, 3u * index + corner);
            let end = edge_of(filling, 3u * index + next);
            let beyond = triangle_beyond(cell, vec3i(local_place(lane)), start, end);
            adjacent[3u * (first + index) + corner] = select(NOWHERE, beyond, beyond < recipe.triangles);
        }
    }
}
