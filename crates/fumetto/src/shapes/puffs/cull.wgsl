// Finds the puffs whose body, and whose ink, the ones drawn first do not hide.

struct Range {
    count: u32,
}

@group(0) @binding(1) var<uniform> range: Range;
@group(0) @binding(2) var<uniform> pyramid: Pyramid;
@group(0) @binding(3) var<storage, read> puffs: array<Puff>;
@group(0) @binding(4) var<storage, read> styles: array<ObjectStyle>;
@group(0) @binding(5) var<storage, read> nearness: array<u32>;
@group(0) @binding(6) var<storage, read_write> flags: array<u32>;

// Whether a ball shows anywhere. It is nearest in its middle only: each cell is compared with how near the
// ball comes there.
fn ball_visible(sprite: Sprite, radius: f32) -> bool {
    let low_px = sprite.px - sprite.radius_px;
    let high_px = sprite.px + sprite.radius_px;
    if any(high_px < vec2f(0.0)) || any(low_px >= view.size_px) {
        return false;
    }
    let level = min(u32(max(ceil(log2(sprite.radius_px * (2.0 / (6.0 * CELL_PX)))), 0.0)), pyramid.levels - 1u);
    let grid = pyramid.level[level];
    let cell_px = CELL_PX * exp2(f32(level));
    let low = max(vec2i(floor(low_px / cell_px)), vec2i(0));
    let high = min(vec2i(floor(high_px / cell_px)), vec2i(grid.yz) - 1);
    var seen = false;
    for (var y = low.y; y <= high.y; y++) {
        for (var x = low.x; x <= high.x; x++) {
            let middle = (vec2f(vec2i(x, y)) + 0.5) * cell_px;
            let offset = max(abs(middle - sprite.px) - 0.5 * cell_px, vec2f(0.0)) / sprite.radius_px;
            let inside = 1.0 - dot(offset, offset);
            let nearest = sprite.distance - radius * sqrt(max(inside, 0.0));
            let hidden = nearness[grid.x + u32(y) * grid.y + u32(x)] >= bitcast<u32>(depth_of(nearest));
            seen |= inside > 0.0 && !hidden;
        }
    }
    return seen;
}

@compute @workgroup_size(256)
fn cull(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= range.count {
        return;
    }
    let puff = puffs[item];
    let style = styles[puff_object(puff)];
    let sprite = sprite_of(puff);
    let fade = puff_fade(puff);
    let front = flags[item] & FRONT;
    var seen = front;
    if sprite.distance > 0.0 && fade.x < 1.0 && fade.y > 0.0 && (style.flags & IN_CEL) != 0u {
        if front == 0u && ball_visible(sprite, puff.radius) {
            seen |= REST;
        }
        let width_px = ink_width_px(style, sprite.distance);
        let behind = sprite.distance + style.ink_offset * 2.0 * puff.radius;
        if (style.flags & HAS_INK) != 0u && visible(sprite.px, vec2f(sprite.radius_px + width_px), behind) {
            seen |= INK;
        }
    }
    flags[item] = seen;
}
