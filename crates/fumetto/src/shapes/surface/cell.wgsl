// What is known of one cell, in a word: in bits 0..8 which corners are inside, in bits 8..16 how many
// vertices its block has before the cell's own, from bit 16 on how many triangles.
//
// Corner number: bit 0 for x, bit 1 for y, bit 2 for z. Corner 0 is the cell's own point.

fn cell_corners(cell: u32) -> u32 {
    return cell & 0xffu;
}

fn cell_vertices_before(cell: u32) -> u32 {
    return (cell >> 8u) & 0xffu;
}

fn cell_triangles_before(cell: u32) -> u32 {
    return cell >> 16u;
}

// Which of the edges from the cell's own point along x, y and z the surface crosses: one bit each.
fn own_crossings(corners: u32) -> u32 {
    let at_ends = ((corners >> 1u) & 3u) | ((corners >> 2u) & 4u);
    return select(at_ends, ~at_ends & 7u, (corners & 1u) == 1u);
}

// Polygons of one case: three edges a triangle, four bits an edge, and in the last four bits the number of
// triangles. See `polygons.rs`.
fn triangles_of(polygons: vec2u) -> u32 {
    return polygons.y >> 28u;
}

fn edge_of(polygons: vec2u, corner: u32) -> u32 {
    return (select(polygons.x, polygons.y, corner >= 8u) >> (corner % 8u * 4u)) & 0xfu;
}
