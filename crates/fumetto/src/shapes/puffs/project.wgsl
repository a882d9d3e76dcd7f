// Puffs as the camera sees them, and how near and far they are.

@group(0) @binding(1) var<uniform> bins: Bins;
@group(0) @binding(2) var<uniform> atlas: Atlas;
@group(0) @binding(3) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(4) var<uniform> lights: Lights;
@group(0) @binding(5) var<storage, read> puffs: array<Puff>;
// As in `Summary`.
@group(0) @binding(6) var<storage, read_write> summary: array<atomic<u32>, 6>;
@group(0) @binding(7) var projected: texture_storage_2d<rgba32uint, write>;

fn picture_of(puff: Puff, sprite: Sprite) -> Picture {
    let level = atlas_level(sprite.radius_px, atlas);
    let middle = atlas_uv(vec2f(0.0), f32(puff_variant(puff)), level, atlas);
    let texels = exp2(-level) * atlas.tile_px * (0.5 / TILE_EXTENT) / sprite.radius_px;
    let size = vec2f(atlas.variants, 2.0) * atlas.tile_px;
    return Picture(middle * size, puff_rotation(puff) * texels, puff_fade(puff).x);
}

// What its outline is drawn with.
fn ink_of(puff: Puff, style: ObjectStyle, sprite: Sprite, width_px: f32) -> vec4u {
    var light = vec2f(0.0);
    if lights.count > 0u {
        let direction = (view.view_from_world * vec4f(toward(lights.light[0], puff.center), 0.0)).xy;
        light = vec2f(direction.x, -direction.y);
    }
    let width = width_px / sprite.radius_px;
    let pen = pen_number(puff_object(puff), SILHOUETTE) + 1u;
    return vec4u(
        pack2x16snorm(light),
        pack2x16float(vec2f(width, width * style.ink_inner)),
        bitcast<u32>(style.ink_lit_thinning),
        pen | (u32(round(255.0 * puff_fade(puff).y)) << 8u),
    );
}

// Most are no extremes, and to look is cheaper than to wait in line.
fn raise(index: u32, to: u32) {
    if atomicLoad(&summary[index]) < to {
        atomicMax(&summary[index], to);
    }
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= bins.count {
        return;
    }
    let puff = puffs[item];
    let style = styles[puff_object(puff)];
    let fade = puff_fade(puff);
    var sprite = sprite_of(puff);
    let drawn = sprite.distance > 0.0 && fade.x < 1.0 && fade.y > 0.0 && (style.flags & IN_CEL) != 0u;
    let width_px = select(0.0, ink_width_px(style, sprite.distance), (style.flags & HAS_INK) != 0u);
    let reach_px = sprite.radius_px + width_px;
    if !drawn || any(sprite.px <= vec2f(-reach_px)) || any(sprite.px >= view.size_px + reach_px) {
        // Without a radius it is on no list.
        textureStore(projected, projected_at(item, 0u), vec4u(0u));
        return;
    }
    textureStore(projected, projected_at(item, 0u), bitcast<vec4u>(vec4f(sprite.px, sprite.radius_px, sprite.distance)));
    textureStore(projected, projected_at(item, 1u), picture_packed(picture_of(puff, sprite)));
    let ink_distance = select(NOWHERE, sprite.distance + style.ink_offset * 2.0 * puff.radius, width_px > 0.0);
    textureStore(projected, projected_at(item, 2u), vec4u(bitcast<u32>(reach_px), puff.look, puff.fade, bitcast<u32>(ink_distance)));
    textureStore(projected, projected_at(item, 3u), ink_of(puff, style, sprite, width_px));
    let nearest = sprite.distance - puff.radius;
    let depth = bitcast<u32>(depth_of(nearest));
    raise(0u, depth);
    raise(1u, ~depth);
    raise(4u, ~bitcast<u32>(max(ink_distance - nearest, 0.0)));
}
