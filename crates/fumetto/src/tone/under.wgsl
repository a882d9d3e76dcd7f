// Height of a picture on which a texel of paper is as large as a pixel. Also in `ink/stroke/polygons.rs`.
const PAPER_HEIGHT: f32 = 720.0;

// What lies under a cel; straight alpha, encoded. Uses `compose`, `under` and `linear` of the program that it is
// part of.
fn under_at(position: vec2f) -> vec4f {
    if compose.under == 0u {
        return vec4f(0.0);
    }
    let image = vec2f(textureDimensions(under));
    if compose.under == 3u {
        // Paper lies as its tooth does under strokes.
        let place = (position + compose.laid_px) * (PAPER_HEIGHT / compose.size_px.y) / image;
        return textureSampleLevel(under, linear, fract(place), 0.0);
    }
    let cover = max(compose.size_px.x / image.x, compose.size_px.y / image.y) * image;
    let shown = select(compose.size_px, cover, compose.under == 2u);
    return textureSampleLevel(under, linear, 0.5 + (position + compose.laid_px - 0.5 * compose.size_px) / shown, 0.0);
}
