// Outlines: a second, larger billboard behind each puff (McGuire & Fein 2004, section 1.3). The margin
// in the atlas makes it larger by the same width all round. It hides nothing itself, so that all ink
// billboards only have to pass the depth of the bodies, in any order.
//
// Ours: lines taper where what lies behind comes close, and thin toward the light.

@group(0) @binding(1) var<uniform> atlas: Atlas;
@group(0) @binding(2) var<storage, read> puffs: array<Puff>;
@group(0) @binding(3) var<storage, read> list: array<u32>;
@group(0) @binding(4) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(5) var<uniform> lights: Lights;
@group(0) @binding(6) var atlas_texture: texture_2d<f32>;
@group(0) @binding(7) var atlas_sampler: sampler;
@group(0) @binding(8) var id_layer: texture_2d<u32>;
@group(0) @binding(9) var depth_layer: texture_depth_2d;

struct Corner {
    @builtin(position) position: vec4f,
    // Place in the puff's own frame, and in the atlas.
    @location(0) @interpolate(linear) p_uv: vec4f,
    // In pairs: where the light comes from in the puff's own frame (0 to 1 long); widths of an outline and
    // of an inner line, in the puff's margin; erosion and the share of the width that goes where it is
    // lit; then pen + 1 and opacity in bytes.
    @location(1) @interpolate(flat) ink: vec4u,
    // Distance of the billboard, distance behind it at which lines have their full width.
    @location(2) @interpolate(flat) taper: vec2f,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let puff = puffs[list[index / 4u]];
    let style = styles[puff_object(puff)];
    let sprite = sprite_of(puff);
    let width_px = ink_width_px(style, sprite.distance);
    let offset = SQUARE[index % 4u] * (sprite.radius_px + width_px);
    let distance = sprite.distance + style.ink_offset * 2.0 * puff.radius;
    let rotation = puff_rotation(puff);
    var light = vec2f(0.0);
    if lights.count > 0u {
        let direction = (view.view_from_world * vec4f(toward(lights.light[0], puff.center), 0.0)).xy;
        light = puff_from_px(vec2f(direction.x, -direction.y), 1.0, rotation);
    }
    let width = width_px / sprite.radius_px;
    let p = puff_from_px(offset, sprite.radius_px, rotation);
    let uv = atlas_uv(p, f32(puff_variant(puff)), atlas_level(sprite.radius_px, atlas), atlas);
    return Corner(
        clip_of(sprite.px + offset, depth_of(distance)),
        vec4f(p, uv),
        vec4u(
            pack2x16snorm(light),
            pack2x16float(vec2f(width, width * style.ink_inner)),
            pack2x16unorm(vec2f(puff_fade(puff).x, style.ink_lit_thinning)),
            (pen_number(puff_object(puff), SILHOUETTE) + 1u) | (u32(round(255.0 * puff_fade(puff).y)) << 8u),
        ),
        vec2f(distance, puff.radius),
    );
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec2u {
    let p = corner.p_uv.xy;
    let light = unpack2x16snorm(corner.ink.x);
    let widths = unpack2x16float(corner.ink.y);
    let erosion_thinning = unpack2x16unorm(corner.ink.z);
    let texel = textureSampleLevel(atlas_texture, atlas_sampler, corner.p_uv.zw, 0.0);
    // Farther out than the atlas tells, a puff is much like a disc.
    let outside = texel.w < 0.01 || any(abs(p) > vec2f(TILE_EXTENT - 0.05));
    let margin = select(texel_margin(texel), 0.9 - length(p), outside);
    let lit = max(dot(p, light) / max(length(p), 1e-3), 0.0);
    let at = vec2i(corner.position.xy);
    var width = widths.x * (1.0 - erosion_thinning.y * lit);
    if textureLoad(id_layer, at, 0).x != 0u {
        let gap = distance_of(textureLoad(depth_layer, at, 0)) - corner.taper.x;
        let taper = clamp(gap / corner.taper.y, 0.0, 1.0);
        width = widths.y * taper * (1.0 - erosion_thinning.y * min(2.0 * lit, 1.0));
    }
    if margin <= erosion_thinning.x - width {
        discard;
    }
    return vec2u(corner.ink.w & 0xffu, corner.ink.w >> 8u);
}
