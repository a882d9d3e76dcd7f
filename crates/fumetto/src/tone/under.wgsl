// What lies under a cel; straight alpha, encoded. Uses `compose`, `under` and `linear` of the program that it is
// part of.
fn under_at(position: vec2f) -> vec4f {
    if compose.under == 0u {
        return vec4f(0.0);
    }
    let image = vec2f(textureDimensions(under));
    let cover = max(compose.size_px.x / image.x, compose.size_px.y / image.y) * image;
    let shown = select(compose.size_px, cover, compose.under == 2u);
    return textureSampleLevel(under, linear, 0.5 + (position + compose.laid_px - 0.5 * compose.size_px) / shown, 0.0);
}
