// How a cel and its ink come onto what lies under them.
struct Compose {
    // Samples along each side of a pixel.
    samples: i32,
    // 0 nothing, 1 an image stretched over the picture, 2 one scaled to cover it, 3 one that repeats.
    under: u32,
    // Pixels along a cell of the layer that tells where there is ink.
    cell: f32,
    // Area of the gathering window, in pixels.
    window: f32,
    // Of what the image is laid over, in pixels, and where in it what is drawn begins.
    size_px: vec2f,
    laid_px: vec2f,
    // Where in the picture what is drawn begins, in samples.
    first_px: vec2f,
    // Pixels along a cell of the layer that tells how much ink is around.
    around_cell: f32,
    // Whether what lies under it is shown in shades of grey.
    is_grey: u32,
}
