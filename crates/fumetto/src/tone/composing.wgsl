// How a cel and its ink come onto what lies under them.
struct Compose {
    // Samples along each side of a pixel.
    samples: i32,
    // 0 nothing, 1 an image stretched over the picture, 2 one scaled to cover it.
    under: u32,
    // Pixels along a cell of the layers that tell how much ink is around.
    cell: f32,
    // Area of the gathering window, in pixels.
    window: f32,
    // Of the picture, in pixels.
    size_px: vec2f,
}
