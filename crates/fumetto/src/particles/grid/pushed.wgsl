// What a step adds to the velocity on faces between two cells, where `is_wall` at the box's low (0) or high (1)
// walls: a closed one lets nothing move, an open one is pushed as the cell at it.
fn pushed(own: vec3f, beyond: vec3f, is_wall: vec3<bool>, end: u32) -> vec3f {
    let bits = vec3u(grid.open) >> (vec3u(0u, 2u, 4u) + end);
    let closed = (bits & vec3u(1u)) == vec3u(0u);
    return select(0.5 * grid.dt * (own + beyond), vec3f(0.0), is_wall & closed);
}
