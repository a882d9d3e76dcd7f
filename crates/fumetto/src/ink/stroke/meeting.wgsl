// What tells ends of lines on models from each other: the two places between which they lie. Along an edge, vertices
// count as one that have the same normal, too, for contours end elsewhere on one side of a hard edge than on the
// other. Uses `seams` of the program that it is part of.
fn meeting(between: vec2u) -> vec2u {
    if between.x == between.y {
        return vec2u(seams[between.x].x);
    }
    let a = seams[between.x].y;
    let b = seams[between.y].y;
    return vec2u(min(a, b), max(a, b));
}
