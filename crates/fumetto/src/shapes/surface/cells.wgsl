// Sorts cells into the 256 cases of marching cubes, and counts their vertices and triangles: one invocation a
// block, all cells of which it takes at once, as bits.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> states: array<u32>;
@group(0) @binding(3) var<storage, read> active_blocks: array<ActiveBlock>;
@group(0) @binding(4) var<storage, read> signs: array<vec2u>;
@group(0) @binding(5) var<storage, read> polygons: array<vec2u>;
@group(0) @binding(6) var<storage, read_write> crossed: array<PackedCrossed>;
// How many vertices, triangles and chunks each block has.
@group(0) @binding(7) var<storage, read_write> counts: array<vec4u>;
// Where each block's list begins; the next one's start is its end.
@group(0) @binding(8) var<storage, read> starts: array<u32>;

fn inside_of(state: u32) -> vec2u {
    if state < ACTIVE {
        return vec2u(select(0u, 0xffffffffu, state == INSIDE));
    }
    return signs[state - ACTIVE];
}

fn crossed_of(grid: Grid, block: vec3i, slot: u32) -> Crossed {
    let corners = corners_of(array(
        inside_of(ACTIVE + slot),
        inside_of(state_beyond(grid, block, 1u)),
        inside_of(state_beyond(grid, block, 2u)),
        inside_of(state_beyond(grid, block, 3u)),
        inside_of(state_beyond(grid, block, 4u)),
        inside_of(state_beyond(grid, block, 5u)),
        inside_of(state_beyond(grid, block, 6u)),
        inside_of(state_beyond(grid, block, 7u)),
    ));
    let words = corners.words;
    let own = words[0];
    let any_inside = own | words[1] | words[2] | words[3] | words[4] | words[5] | words[6] | words[7];
    let all_inside = own & words[1] & words[2] & words[3] & words[4] & words[5] & words[6] & words[7];
    var result = Crossed(own, own ^ words[1], own ^ words[2], own ^ words[4], vec2u(0u), vec2u(0u), vec2u(0u));
    var left = any_inside & ~all_inside;
    while any(left != vec2u(0u)) {
        let low = left.x != 0u;
        let cell = select(32u + firstTrailingBit(left.y), firstTrailingBit(left.x), low);
        let bit = bit_of(cell);
        left &= ~bit;
        let triangles = triangles_in(polygons[case_of(corners, cell)]);
        result.ones |= select(vec2u(0u), bit, (triangles & 1u) != 0u);
        result.twos |= select(vec2u(0u), bit, (triangles & 2u) != 0u);
        result.fours |= select(vec2u(0u), bit, (triangles & 4u) != 0u);
    }
    return result;
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = (group.y * groups.x + group.x) * 256u + lane;
    let grid = grid();
    let blocks = lattice.active_blocks;
    if slot >= recipe.active_blocks {
        return;
    }
    var own_counts = vec4u(0u);
    if slot < blocks {
        let block = active_blocks[slot];
        let own = crossed_of(grid, block.place, slot);
        crossed[slot] = packed_crossed(own, vec2u(starts[block.number], starts[block.number + 1u]));
        let vertices = vertices_of(own);
        let triangles = triangles_of(own);
        own_counts = vec4u(vertices, triangles, chunks_of(vertices, triangles), 0u);
    }
    counts[slot] = own_counts;
}
