// Whether a rectangle of the screen, `half` its sides, shows anything at `distance`. Uses `pyramid` and
// `nearness` of the program that it is part of.
fn visible(px: vec2f, half: vec2f, distance: f32) -> bool {
    let low_px = px - half;
    let high_px = px + half;
    if any(high_px < vec2f(0.0)) || any(low_px >= view.size_px) {
        return false;
    }
    let level = min(u32(max(ceil(log2(max(half.x, half.y) * (2.0 / (3.0 * CELL_PX)))), 0.0)), pyramid.levels - 1u);
    let grid = pyramid.level[level];
    let cell_px = CELL_PX * exp2(f32(level));
    let low = max(vec2i(floor(low_px / cell_px)), vec2i(0));
    let high = min(vec2i(floor(high_px / cell_px)), vec2i(grid.yz) - 1);
    let bits = bitcast<u32>(depth_of(distance));
    var seen = false;
    for (var y = low.y; y <= high.y; y++) {
        for (var x = low.x; x <= high.x; x++) {
            seen |= nearness[grid.x + u32(y) * grid.y + u32(x)] < bits;
        }
    }
    return seen;
}
