// Of a direction of any length, a unit vector at twice its angle: the same for the opposite direction.
fn twice(direction: vec2f) -> vec2f {
    let square = max(dot(direction, direction), 1e-30);
    return vec2f(direction.x * direction.x - direction.y * direction.y, 2.0 * direction.x * direction.y) / square;
}
