// For all cells of a block at once: which of their corners are inside. A word holds one corner of all cells.

struct Corners {
    words: array<vec2u, 8>,
}

// What points show that lie one step along an axis, in the block and the one beyond it.
fn moved_x(own: vec2u, beyond: vec2u) -> vec2u {
    return ((own >> vec2u(1u)) & vec2u(0x77777777u)) | ((beyond << vec2u(3u)) & vec2u(0x88888888u));
}

fn moved_y(own: vec2u, beyond: vec2u) -> vec2u {
    return ((own >> vec2u(4u)) & vec2u(0x0fff0fffu)) | ((beyond << vec2u(12u)) & vec2u(0xf000f000u));
}

fn moved_z(own: vec2u, beyond: vec2u) -> vec2u {
    return vec2u((own.x >> 16u) | (own.y << 16u), (own.y >> 16u) | (beyond.x << 16u));
}

// From a block and those beyond its upper faces, by corner number.
fn corners_of(inside: array<vec2u, 8>) -> Corners {
    let x0 = moved_x(inside[0], inside[1]);
    let x2 = moved_x(inside[2], inside[3]);
    let x4 = moved_x(inside[4], inside[5]);
    let x6 = moved_x(inside[6], inside[7]);
    let y0 = moved_y(inside[0], inside[2]);
    let y4 = moved_y(inside[4], inside[6]);
    let xy0 = moved_y(x0, x2);
    let xy4 = moved_y(x4, x6);
    return Corners(array(
        inside[0],
        x0,
        y0,
        xy0,
        moved_z(inside[0], inside[4]),
        moved_z(x0, x4),
        moved_z(y0, y4),
        moved_z(xy0, xy4),
    ));
}

// One cell's case.
fn case_of(corners: Corners, cell: u32) -> u32 {
    return has(corners.words[0], cell)
        | (has(corners.words[1], cell) << 1u)
        | (has(corners.words[2], cell) << 2u)
        | (has(corners.words[3], cell) << 3u)
        | (has(corners.words[4], cell) << 4u)
        | (has(corners.words[5], cell) << 5u)
        | (has(corners.words[6], cell) << 6u)
        | (has(corners.words[7], cell) << 7u);
}

// Which blocks lie beyond the upper faces of one: state of that whose corner number is given.
fn state_beyond(grid: Grid, block: vec3i, corner: u32) -> u32 {
    let step = vec3i((vec3u(corner) >> vec3u(0u, 1u, 2u)) & vec3u(1u));
    let number = block_number(grid, block + step);
    if number == NOWHERE {
        return OUTSIDE;
    }
    return states[number];
}
