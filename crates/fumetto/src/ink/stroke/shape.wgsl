// Where strokes run.
struct Shape {
    // From the picture's top left.
    px: vec2f,
    // One pixel along the line.
    tangent: vec2f,
    // Of the line, over pixels.
    bend: f32,
    // Of the piece that begins here: pixels before and after it in which its line is seen, as far as is looked.
    before: f32,
    after: f32,
    // Whether it is drawn.
    shows: u32,
}

// So far is looked along a line, in pixels: over what changes toward its ends, and what it takes to be worth drawing.
fn sight_px(style: StrokeStyle, height: f32) -> f32 {
    return max((style.taper + 1.0) * height, style.shortest_px);
}
