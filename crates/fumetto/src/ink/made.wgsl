// Candidates of a surface that the device makes: a contour may cross any of its triangles. Uses `triangles` and
// `parts` of the program that it is part of.

// Arguments of the draw over all of them: three vertices to a triangle.
struct Drawn {
    vertices: u32,
    instances: u32,
    first_vertex: u32,
    first_instance: u32,
}

@group(0) @binding(1) var<storage, read> drawn: Drawn;

// Where there is no such triangle, a candidate of no kind.
fn candidate_at(number: u32) -> Candidate {
    if 3u * number >= drawn.vertices {
        return Candidate();
    }
    let triangle = triangles[drawn.first_vertex / 3u + number];
    return Candidate(triangle.corners, CONTOUR | (parts[triangle.part].object << 16u), vec3u(0u), 0u);
}

// Place on the list, and corner of the strip, of a vertex that is drawn without indices.
fn strip_corner(index: u32) -> vec2u {
    return vec2u(index / 6u, array(0u, 1u, 2u, 0u, 2u, 3u)[index % 6u]);
}
