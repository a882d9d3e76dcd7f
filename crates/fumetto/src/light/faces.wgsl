// Lists of the faces of shadow volumes. They are filled in whatever order invocations come: only sums of whole
// numbers are made of them.

@group(0) @binding(7) var<storage, read_write> facings: array<u32>;
// Caps whose lit side is seen from the front on, the others from the end on.
@group(0) @binding(8) var<storage, read_write> caps: array<u32>;
// Vertices at both ends, in the order in which the side's volume runs along it.
@group(0) @binding(9) var<storage, read_write> sides: array<vec2u>;
// Arguments of three indirect draws; each begins with the number of vertices, and of the second the third word is
// its first vertex.
@group(0) @binding(10) var<storage, read_write> draws: array<atomic<u32>, 12>;

fn add_cap(triangle: u32, is_turned: bool, is_lit_seen: bool) {
    let cap = triangle | select(0u, TURNED, is_turned);
    if is_lit_seen {
        caps[atomicAdd(&draws[0], 3u) / 3u] = cap;
    } else {
        atomicAdd(&draws[4], 3u);
        caps[atomicSub(&draws[6], 3u) / 3u - 1u] = cap;
    }
}

fn add_side(ends: vec2u) {
    let at = atomicAdd(&draws[8], volumes.side_vertices) / volumes.side_vertices;
    if at < arrayLength(&sides) {
        sides[at] = ends;
    } else {
        atomicSub(&draws[8], volumes.side_vertices);
    }
}
