// What tells ends of contours on a surface that the device makes from each other: its vertices are shared.
fn meeting(between: vec2u) -> vec2u {
    return vec2u(min(between.x, between.y), max(between.x, between.y));
}
