// The box of air. Velocity lies on the faces of cells, each component on those across it (Harlow & Welch 1965);
// all else in their middles. Every component's list has room for one face more than there are cells along
// each side.

struct Grid {
    // Lowest corner, and the side of a cell; in metres.
    origin: vec3f,
    side: f32,
    cells: vec3u,
    // A bit for each open wall: low x, high x, low y, high y, low z, high z.
    open: u32,
    // Velocity of the air beyond open walls, in m/s.
    outside: vec3f,
    // Seconds in which it moves.
    dt: f32,
    // By how much that is faster than a step ago: all the air feels it.
    gust: vec3f,
    // 1: there was no step before, and the air moves as that outside.
    begins: u32,
    // What is left of heat and of smoke after these.
    fade: vec2f,
    sources: u32,
    forces: u32,
    // Acceleration of the hottest air, upward; in m/s².
    lift: f32,
    // Of vorticity, per second.
    confinement: f32,
    // In m²/s.
    viscosity: f32,
    // 1: there are obstacles.
    solids: u32,
}

fn cell_index(c: vec3u) -> u32 {
    return (c.z * grid.cells.y + c.y) * grid.cells.x + c.x;
}

// From a face to the next along each axis.
fn face_stride() -> vec3u {
    let row = grid.cells.x + 1u;
    return vec3u(1u, row, row * (grid.cells.y + 1u));
}

fn face_index(f: vec3u) -> u32 {
    return dot(f, face_stride());
}

// Whether there is no wall at the low (0) or high (1) end of an axis.
fn is_open(axis: u32, end: u32) -> bool {
    return (grid.open & (1u << (2u * axis + end))) != 0u;
}

// Whether a place, in cells from the lowest corner, lies beyond an open wall.
fn is_outside(p: vec3f) -> bool {
    let bits = vec3u(grid.open) >> vec3u(0u, 2u, 4u);
    let low = (bits & vec3u(1u)) != vec3u(0u);
    let high = (bits & vec3u(2u)) != vec3u(0u);
    return any((low & (p < vec3f(0.0))) | (high & (p > vec3f(grid.cells))));
}
