// A puff's billboard and its picture in the atlas.

// Half the width of a puff's tile over the puff's radius: room for ink around it.
const TILE_EXTENT: f32 = 1.25;

struct Atlas {
    variants: f32,
    tile_px: f32,
    levels: f32,
}

// From an offset in pixels (y down) to the puff's own frame (radius 1, y up).
fn puff_from_px(offset_px: vec2f, radius_px: f32, rotation: vec2f) -> vec2f {
    let p = vec2f(offset_px.x, -offset_px.y) / radius_px;
    return vec2f(rotation.x * p.x + rotation.y * p.y, rotation.x * p.y - rotation.y * p.x);
}

// From the puff's own frame back to the screen's (y up).
fn screen_from_puff(p: vec2f, rotation: vec2f) -> vec2f {
    return vec2f(rotation.x * p.x - rotation.y * p.y, rotation.y * p.x + rotation.x * p.y);
}

fn atlas_level(radius_px: f32, atlas: Atlas) -> f32 {
    return clamp(floor(log2(atlas.tile_px / (2.0 * TILE_EXTENT * radius_px)) + 0.5), 0.0, atlas.levels - 1.0);
}

// Where in the atlas. Beyond the tile (where p is beyond TILE_EXTENT) lies something else.
fn atlas_uv(p: vec2f, variant: f32, level: f32, atlas: Atlas) -> vec2f {
    let scale = exp2(-level);
    let tile = vec2f(p.x, -p.y) * (0.5 / TILE_EXTENT) + 0.5;
    return vec2f((variant + tile.x * scale) / atlas.variants, 1.0 - scale + 0.5 * tile.y * scale);
}

// What a texel of the atlas says.
fn texel_normal(texel: vec4f) -> vec2f {
    return texel.xy * 2.0 - 1.0;
}

fn texel_margin(texel: vec4f) -> f32 {
    return texel.w * 1.5 - 0.5;
}
