// What the mask knows of a pixel. Uses `mask` of the program that it is part of.
fn marks_at(px: vec2u, width: u32) -> u32 {
    return (mask[px.y * ((width + 1u) / 2u) + px.x / 2u] >> (px.x % 2u * 16u)) & 0xffffu;
}
