// What the surface is in one block, as bits of its 64 points, or of the cells above these.
//
// Corner number of a cell: bit 0 for x, bit 1 for y, bit 2 for z. Corner 0 is the cell's own point.
struct Crossed {
    // Points that are inside.
    inside: vec2u,
    // Points from which the surface crosses the edge along x, along y, along z.
    x: vec2u,
    y: vec2u,
    z: vec2u,
    // The number of triangles in each cell, bit by bit.
    ones: vec2u,
    twos: vec2u,
    fours: vec2u,
}

// As it lies in memory: a processor that draws takes as long to read one number as to read four.
struct PackedCrossed {
    inside_x: vec4u,
    y_z: vec4u,
    ones_twos: vec4u,
    // And where the block's list begins and ends.
    fours_list: vec4u,
}

fn packed_crossed(block: Crossed, list: vec2u) -> PackedCrossed {
    return PackedCrossed(
        vec4u(block.inside, block.x),
        vec4u(block.y, block.z),
        vec4u(block.ones, block.twos),
        vec4u(block.fours, list),
    );
}

fn unpacked_crossed(block: PackedCrossed) -> Crossed {
    return Crossed(
        block.inside_x.xy,
        block.inside_x.zw,
        block.y_z.xy,
        block.y_z.zw,
        block.ones_twos.xy,
        block.ones_twos.zw,
        block.fours_list.xy,
    );
}

fn bits_of(word: vec2u) -> u32 {
    let bits = countOneBits(word);
    return bits.x + bits.y;
}

fn has(word: vec2u, point: u32) -> u32 {
    return (select(word.x, word.y, point >= 32u) >> (point & 31u)) & 1u;
}

fn bit_of(point: u32) -> vec2u {
    return select(vec2u(0u, 1u), vec2u(1u, 0u), point < 32u) << vec2u(point & 31u);
}

// Bits of all points before one.
fn before(point: u32) -> vec2u {
    let part = (1u << (point & 31u)) - 1u;
    return select(vec2u(part, 0u), vec2u(0xffffffffu, part), point >= 32u);
}

// The `index`-th bit that is set, from the lowest.
fn nth_point(word: vec2u, index: u32) -> u32 {
    var point = 0u;
    var left = index;
    for (var half = 32u; half > 0u; half /= 2u) {
        let lower = bits_of(word & before(point + half) & ~before(point));
        let beyond = left >= lower;
        point += select(0u, half, beyond);
        left -= select(0u, lower, beyond);
    }
    return point;
}

// The bit that is set after one, or the last there can be.
fn next_point(word: vec2u, point: u32) -> u32 {
    let left = word & ~before(point) & ~bit_of(point);
    return min(select(32u + firstTrailingBit(left.y), firstTrailingBit(left.x), left.x != 0u), 63u);
}

fn vertices_of(block: Crossed) -> u32 {
    return bits_of(block.x) + bits_of(block.y) + bits_of(block.z);
}

fn triangles_of(block: Crossed) -> u32 {
    return bits_of(block.ones) + 2u * bits_of(block.twos) + 4u * bits_of(block.fours);
}

// Vertices come by axis, then by point.
fn vertices_before(block: Crossed, axis: u32, point: u32) -> u32 {
    let lower = before(point);
    if axis == 0u {
        return bits_of(block.x & lower);
    }
    if axis == 1u {
        return bits_of(block.x) + bits_of(block.y & lower);
    }
    return bits_of(block.x) + bits_of(block.y) + bits_of(block.z & lower);
}

fn triangles_before(block: Crossed, cell: u32) -> u32 {
    let lower = before(cell);
    return bits_of(block.ones & lower) + 2u * bits_of(block.twos & lower) + 4u * bits_of(block.fours & lower);
}

// Polygons of one case: three edges a triangle, four bits an edge, and in the last four bits the number of
// triangles. See `polygons.rs`.
fn triangles_in(polygons: vec2u) -> u32 {
    return polygons.y >> 28u;
}

fn edge_of(polygons: vec2u, corner: u32) -> u32 {
    return (select(polygons.x, polygons.y, corner >= 8u) >> (corner % 8u * 4u)) & 0xfu;
}
