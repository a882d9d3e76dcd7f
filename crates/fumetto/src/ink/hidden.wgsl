// What hides lines. Uses `depth_layer` of the program that it is part of.

// Depths that differ by this share are equal: the layer is not exact, nor are models.
const DEPTH_TOLERANCE: f32 = 2e-4;

// Whether something lies before a place of a contour, whose triangle is as near as `nearest` tells.
fn hides_contour(middle: vec2f, nearest: f32) -> bool {
    // Seen so nearly edge-on, the surface comes much nearer within a pixel: the farthest of the four around the
    // place counts.
    let first = vec2i(floor(middle - 0.5));
    let last = vec2i(view.size_px) - 1;
    var farthest = 1.0;
    for (var pixel = 0; pixel < 4; pixel++) {
        let at = clamp(first + vec2i(pixel & 1, pixel >> 1), vec2i(0), last);
        farthest = min(farthest, textureLoad(depth_layer, at, 0));
    }
    return farthest > nearest * (1.0 + DEPTH_TOLERANCE);
}

// Likewise of an edge at some depth, between triangles that lie in two planes.
fn hides_edge(middle: vec2f, depth: f32, left: vec3f, right: vec3f, nearest: f32) -> bool {
    let at = clamp(vec2i(floor(middle)), vec2i(0), vec2i(view.size_px) - 1);
    let ray = ray_of(vec2f(at) + 0.5);
    // The nearer of the two sides, as deep as it would be at that pixel.
    let sides = max(dot(left, ray), dot(right, ray));
    let surface = clamp(sides, depth, max(depth, nearest));
    return textureLoad(depth_layer, at, 0) > surface * (1.0 + DEPTH_TOLERANCE);
}
