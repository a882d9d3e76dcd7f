// Tiles of a picture, of which only some are drawn.

// Pixels along the side of a tile that lines may reach. Also in `flood.rs`.
const TILE: u32 = 32u;

// Pixels along the side of a tile that lines are looked for in. Also in `image.rs`.
const LOOK_TILE: u32 = 16u;

// Column and row of a tile, which has two triangles.
fn tile_of(index: u32, size: vec2u, side: u32) -> vec2u {
    let columns = (size.x + side - 1u) / side;
    return vec2u((index / 6u) % columns, (index / 6u) / columns);
}

// One of the corners of a tile's triangles; of one that is not drawn, they have no size.
fn tile_corner(index: u32, size: vec2u, side: u32, drawn: bool) -> vec4f {
    let first = tile_of(index, size, side) * side;
    let corner = array(0u, 1u, 3u, 0u, 3u, 2u)[index % 6u];
    let end = select(first, min(first + side, size), vec2u(corner & 1u, corner >> 1u) == vec2u(1u));
    let ndc = vec2f(select(first, end, drawn)) / vec2f(size) * 2.0 - 1.0;
    return vec4f(ndc.x, -ndc.y, 0.0, 1.0);
}
