// The ink that is drawn at one sample: straight alpha, encoded; nothing where a line is too short to read.
// Uses `compose`, `pens`, `ink`, `around` and `linear` of the program that it is part of.
fn line_at(at: vec2i) -> vec4f {
    let mark = textureLoad(ink, at, 0).xy;
    if mark.x == 0u {
        return vec4f(0.0);
    }
    let pen = pens[mark.x - 1u];
    let cells = (vec2f(at) + compose.first_px) / (compose.around_cell * vec2f(textureDimensions(around)));
    let inked_px = textureSampleLevel(around, linear, cells, 0.0).x * compose.window;
    // A line is at least as wide as it is where the light thins it.
    let kept = inked_px >= pen.shortest_px * pen.thinnest_px * 0.7;
    return select(vec4f(0.0), vec4f(pen.colour, pen.opacity * f32(mark.y) / 255.0), kept);
}
