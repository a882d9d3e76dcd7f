// Sides of shadow volumes, from an edge to infinitely far away.

// Numbers of vertices.
@group(0) @binding(4) var<storage, read> sides: array<vec2u>;

// Corners of a quad's two triangles: 0 and 1 are the edge's ends, 3 and 2 the same at infinity. The first
// alone is enough where 3 is 2.
const CORNERS = array<u32, 6>(0u, 1u, 2u, 0u, 2u, 3u);

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let ends = sides[index / volumes.side_vertices];
    let corner = CORNERS[index % volumes.side_vertices];
    // Seen from outside, a side runs against its triangle.
    let place = vertices[select(ends.x, ends.y, corner == 0u || corner == 3u)].position;
    if corner >= 2u {
        return Corner(clip_at_infinity(place), 1.0);
    }
    return Corner(clip_from_world(place), 1.0);
}
