// How the strokes of one pen are drawn. Lengths are in heights unless their names say otherwise.
struct StrokeStyle {
    // The larger of the two counts.
    height_px: f32,
    height_m: f32,
    // Of the texture along the stroke.
    length: f32,
    // Share of the height that lies outside of the body.
    outward: f32,
    taper: f32,
    pressure: f32,
    curvature: f32,
    // Power of the distance by which strokes get lighter, and the distance at which they are as they are.
    distance: f32,
    reference_m: f32,
    wobble: f32,
    overshoot: f32,
    grain: f32,
    shortest_px: f32,
    passes: u32,
    // Layer of the texture array.
    layer: u32,
    // Another for every drawing that the hand makes.
    seed: u32,
}

// Height of a stroke at a distance, in pixels.
fn stroke_height_px(style: StrokeStyle, distance: f32) -> f32 {
    let lighter = pow(min(style.reference_m / distance, 1.0), style.distance);
    return max(lighter * max(style.height_px, style.height_m * view.focal_px / distance), 1.0);
}
