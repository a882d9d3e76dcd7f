// The body: nailboards, billboards whose pixels carry depth (Schaufler 1997; McGuire & Fein 2004,
// section 1.4). Fills the depth and id layers only: what the nearest puff looks like is worked out
// once per pixel afterwards, however many puffs lie behind.

@group(0) @binding(1) var<uniform> atlas: Atlas;
@group(0) @binding(2) var<storage, read> puffs: array<Puff>;
@group(0) @binding(3) var<storage, read> list: array<u32>;
@group(0) @binding(4) var atlas_texture: texture_2d<f32>;
@group(0) @binding(5) var atlas_sampler: sampler;

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) @interpolate(linear) uv: vec2f,
    // Distance of the middle, radius in metres and erosion as bits; puff's number + 1. All in one, because a
    // software rasteriser sets up each value that a triangle carries.
    @location(1) @interpolate(flat) puff: vec4u,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let id = list[index / 4u];
    let puff = puffs[id];
    let sprite = sprite_of(puff);
    // The square turns with the puff, so that it never leaves the puff's tile.
    let p = SQUARE[index % 4u];
    let on_screen = screen_from_puff(p, puff_rotation(puff)) * sprite.radius_px;
    let offset = vec2f(on_screen.x, -on_screen.y);
    return Corner(
        // At its nearest depth, so that pixels are only ever pushed back.
        clip_of(sprite.px + offset, depth_of(sprite.distance - puff.radius)),
        atlas_uv(p, f32(puff_variant(puff)), atlas_level(sprite.radius_px, atlas), atlas),
        vec4u(bitcast<vec3u>(vec3f(sprite.distance, puff.radius, puff_fade(puff).x)), id + 1u),
    );
}

struct Body {
    @builtin(frag_depth) depth: f32,
    @location(0) id: u32,
}

@fragment
fn fragment(corner: Corner) -> Body {
    let puff = bitcast<vec3f>(corner.puff.xyz);
    let texel = textureSampleLevel(atlas_texture, atlas_sampler, corner.uv, 0.0);
    if texel_margin(texel) <= puff.z {
        discard;
    }
    return Body(depth_of(puff.x - texel.z * puff.y), corner.puff.w);
}
