// A puff as the camera sees it: worked out once, looked at from many pixels. In textures, for software
// rasterisers read those for eight invocations at once, and storage buffers for one after another.

// Texels of a puff: its middle and radius in pixels, its distance; then its picture; then its ink.
const PROJECTED_TEXELS: u32 = 4u;
// Puffs in a row of the texture. Also in `bins.rs`.
const PROJECTED_ROW: u32 = 1024u;

// Farther than anything that is seen.
const NOWHERE: f32 = 1e30;

fn projected_at(puff: u32, texel: u32) -> vec2u {
    return vec2u(puff % PROJECTED_ROW * PROJECTED_TEXELS + texel, puff / PROJECTED_ROW);
}

// Where a puff's picture lies in the atlas, in texels.
struct Picture {
    middle: vec2f,
    // From a pixel to its neighbour on the right; turned by a right angle, to the one below.
    step: vec2f,
    // Erosion.
    erosion: f32,
}

// The middle is at a multiple of half a texel.
fn picture_packed(picture: Picture) -> vec4u {
    let middle = vec2u(2.0 * picture.middle + 0.5);
    return vec4u(bitcast<vec2u>(picture.step), middle.x | (middle.y << 16u), bitcast<u32>(picture.erosion));
}

fn picture_unpacked(packed: vec4u) -> Picture {
    let middle = vec2f(vec2u(packed.z & 0xffffu, packed.z >> 16u)) * 0.5;
    return Picture(middle, bitcast<vec2f>(packed.xy), bitcast<f32>(packed.w));
}

// Margins as `heights` holds them. Bytes are rounded there: a place is inside where it is so by half a step.
fn margin_bytes(margin: vec4f) -> vec4f {
    return (margin + 0.5) * (255.0 / 1.5) + 0.5;
}

// The texel, from its own middle, at an offset from the puff's middle in pixels.
fn texel_of(picture: Picture, offset_px: vec2f) -> vec2f {
    let turned = vec2f(-picture.step.y, picture.step.x);
    return picture.middle - 0.5 + offset_px.x * picture.step + offset_px.y * turned;
}
