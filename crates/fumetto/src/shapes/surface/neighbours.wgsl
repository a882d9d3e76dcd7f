// The block and those beyond its upper faces, by corner number: their states.
var<workgroup> neighbours: array<u32, 8>;

// For the first eight lanes of a workgroup.
fn meet_neighbours(block: u32, lane: u32) {
    if lane < 8u {
        let step = vec3i((vec3u(lane) >> vec3u(0u, 1u, 2u)) & vec3u(1u));
        let number = block_number(lattice.blocks, block_place(lattice.blocks, block) + step);
        var state = OUTSIDE;
        if number != NOWHERE {
            state = states[number];
        }
        neighbours[lane] = state;
    }
}

// Which of the eight a place belongs to that is at most one block away.
fn neighbour_of(place: vec3u) -> u32 {
    let beyond = place >> vec3u(2u);
    return beyond.x | (beyond.y << 1u) | (beyond.z << 2u);
}
