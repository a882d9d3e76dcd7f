// Finds the puffs whose body the ones drawn first do not hide, and then those whose ink no body hides.

struct Range {
    count: u32,
}

@group(0) @binding(1) var<uniform> range: Range;
@group(0) @binding(2) var<uniform> pyramid: Pyramid;
@group(0) @binding(3) var<storage, read> puffs: array<Puff>;
@group(0) @binding(4) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(5) var<storage, read> nearness: array<u32>;
@group(0) @binding(6) var<storage, read_write> flags: array<u32>;

// The cells that a circle may touch, on a level where it is about six of them wide; none off the screen.
struct Cells {
    grid: vec4u,
    cell_px: f32,
    low: vec2i,
    high: vec2i,
}

fn cells_about(px: vec2f, radius_px: f32) -> Cells {
    let level = min(u32(max(ceil(log2(radius_px * (2.0 / (6.0 * CELL_PX)))), 0.0)), pyramid.levels - 1u);
    let grid = pyramid.level[level];
    let cell_px = CELL_PX * exp2(f32(level));
    let low = max(vec2i(floor((px - radius_px) / cell_px)), vec2i(0));
    let high = min(vec2i(floor((px + radius_px) / cell_px)), vec2i(grid.yz) - 1);
    return Cells(grid, cell_px, low, high);
}

// From the middle of a circle to the nearest place of a cell.
fn offset_of(cell: vec2i, cell_px: f32, px: vec2f) -> vec2f {
    let middle = (vec2f(cell) + 0.5) * cell_px;
    return max(abs(middle - px) - 0.5 * cell_px, vec2f(0.0));
}

// Whether a flat disc shows anywhere.
fn disc_visible(px: vec2f, radius_px: f32, distance: f32) -> bool {
    let cells = cells_about(px, radius_px);
    let bits = bitcast<u32>(depth_of(distance));
    var seen = false;
    for (var y = cells.low.y; y <= cells.high.y; y++) {
        for (var x = cells.low.x; x <= cells.high.x; x++) {
            let offset = offset_of(vec2i(x, y), cells.cell_px, px) / radius_px;
            let hidden = nearness[cells.grid.x + u32(y) * cells.grid.y + u32(x)] >= bits;
            seen |= dot(offset, offset) < 1.0 && !hidden;
        }
    }
    return seen;
}

// Whether a ball shows anywhere. It is nearest in its middle only: each cell is compared with how near the
// ball comes there.
fn ball_visible(sprite: Sprite, radius: f32) -> bool {
    let cells = cells_about(sprite.px, sprite.radius_px);
    var seen = false;
    for (var y = cells.low.y; y <= cells.high.y; y++) {
        for (var x = cells.low.x; x <= cells.high.x; x++) {
            let offset = offset_of(vec2i(x, y), cells.cell_px, sprite.px) / sprite.radius_px;
            let inside = 1.0 - dot(offset, offset);
            let nearest = sprite.distance - radius * sqrt(max(inside, 0.0));
            let hidden = nearness[cells.grid.x + u32(y) * cells.grid.y + u32(x)] >= bitcast<u32>(depth_of(nearest));
            seen |= inside > 0.0 && !hidden;
        }
    }
    return seen;
}

fn is_drawn(puff: Puff, sprite: Sprite) -> bool {
    let fade = puff_fade(puff);
    return sprite.distance > 0.0 && fade.x < 1.0 && fade.y > 0.0 && (styles[puff_object(puff)].flags & IN_CEL) != 0u;
}

@compute @workgroup_size(256)
fn bodies(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= range.count {
        return;
    }
    let puff = puffs[item];
    let sprite = sprite_of(puff);
    let front = flags[item] & FRONT;
    var seen = front;
    if front == 0u && is_drawn(puff, sprite) && ball_visible(sprite, puff.radius) {
        seen = REST;
    }
    flags[item] = seen;
}

@compute @workgroup_size(256)
fn inks(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= range.count {
        return;
    }
    let puff = puffs[item];
    let sprite = sprite_of(puff);
    let style = styles[puff_object(puff)];
    var seen = 0u;
    if (style.flags & HAS_INK) != 0u && is_drawn(puff, sprite) {
        let width_px = ink_width_px(style, sprite.distance);
        let behind = sprite.distance + style.ink_offset * 2.0 * puff.radius;
        seen = select(0u, INK, disc_visible(sprite.px, sprite.radius_px + width_px, behind));
    }
    flags[item] = seen;
}
