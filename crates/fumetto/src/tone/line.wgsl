// Ink at one sample.
struct Line {
    // Straight alpha, encoded.
    colour: vec4f,
    // How much of what lies under it it covers.
    share: f32,
}

// The ink that is drawn at one sample; nothing where a line is too short to read.
// Uses `compose`, `pens`, `ink`, `around` and `linear` of the program that it is part of.
fn line_at(at: vec2i) -> Line {
    let mark = textureLoad(ink, at, 0).xy;
    if mark.x == 0u {
        return Line(vec4f(0.0), 0.0);
    }
    let pen = pens[mark.x - 1u];
    let cells = (vec2f(at) + compose.first_px) / (compose.around_cell * vec2f(textureDimensions(around)));
    let inked_px = textureSampleLevel(around, linear, cells, 0.0).x * compose.window;
    // A line is at least as wide as it is where the light thins it.
    let kept = inked_px >= pen.shortest_px * pen.thinnest_px * 0.7;
    let strength = f32(mark.y) / 255.0;
    // What an outline of a puff covers fades with it; strokes let through what lies under them.
    if (pen.flags & HAS_STROKES) != 0u {
        return Line(vec4f(pen.colour, pen.opacity), select(0.0, strength, kept));
    }
    return Line(vec4f(pen.colour, pen.opacity * strength), f32(kept));
}
