// Which lines of sight are followed: that through the middle of each square of pixels, and where there are several pixels
// to a square, through those of one more all round. Squares begin where the picture does, so tiles of it share them.
// Uses `recipe` of the program that it is part of.

fn is_each_pixel() -> bool {
    return recipe.pixels == 1.0;
}

// From what is drawn to squares, whose middles are at halves.
fn square_of(px: vec2f) -> vec2f {
    let before = floor(view.first_px / recipe.pixels);
    return (px + view.first_px) / recipe.pixels - before + select(1.0, 0.0, is_each_pixel());
}

fn px_of_square(square: vec2f) -> vec2f {
    let before = floor(view.first_px / recipe.pixels);
    return (square - select(1.0, 0.0, is_each_pixel()) + before) * recipe.pixels - view.first_px;
}

// The depth of what is solid there; 0 where nothing is.
fn solid_depth(px: vec2f) -> f32 {
    let last = vec2i(textureDimensions(depth_layer)) - 1;
    return textureLoad(depth_layer, clamp(vec2i(px), vec2i(0), last), 0);
}
