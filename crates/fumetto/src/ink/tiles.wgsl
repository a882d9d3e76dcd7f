// Tiles of a picture, of which only some are drawn. Uses `tiles` of the program that it is part of.

// Pixels along the side of a tile. Also in `flood.rs`.
const TILE: u32 = 32u;

// Two triangles for each tile; the others have no size.
fn tile_corner(index: u32, size: vec2u, drawn: bool) -> vec4f {
    let columns = (size.x + TILE - 1u) / TILE;
    let tile = vec2u((index / 6u) % columns, (index / 6u) / columns);
    let first = tile * TILE;
    let corner = array(0u, 1u, 3u, 0u, 3u, 2u)[index % 6u];
    let end = select(first, min(first + TILE, size), vec2u(corner & 1u, corner >> 1u) == vec2u(1u));
    let ndc = vec2f(select(first, end, drawn)) / vec2f(size) * 2.0 - 1.0;
    return vec4f(ndc.x, -ndc.y, 0.0, 1.0);
}
