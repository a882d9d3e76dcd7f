// Stamps the solid core of every puff into the occlusion pyramid.

struct Core {
    // Radius of the disc that every variant surely covers, over the puff's.
    radius: f32,
    // How far in front of its middle the puff reaches all over that disc, over its radius.
    height: f32,
    first: u32,
    count: u32,
}

@group(0) @binding(1) var<uniform> core: Core;
@group(0) @binding(2) var<uniform> pyramid: Pyramid;
@group(0) @binding(3) var<storage, read> puffs: array<Puff>;
@group(0) @binding(4) var<storage, read_write> nearness: array<atomic<u32>>;

@compute @workgroup_size(256)
fn occluders(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= core.count {
        return;
    }
    let puff = puffs[core.first + item];
    let sprite = sprite_of(puff);
    let fade = puff_fade(puff);
    let radius_px = sprite.radius_px * core.radius;
    // The coarsest level at which a few whole cells fit into the core.
    let level = i32(floor(log2(max(radius_px, 1e-6) * (0.5 / CELL_PX))));
    if level < 0 || fade.x > 0.0 || fade.y < 1.0 {
        return;
    }
    let grid = pyramid.level[min(u32(level), pyramid.levels - 1u)];
    let cell_px = CELL_PX * exp2(f32(min(u32(level), pyramid.levels - 1u)));
    let bits = bitcast<u32>(1.0 / max(sprite.distance - core.height * puff.radius, view.near));
    let low = max(vec2i(floor((sprite.px - radius_px) / cell_px)), vec2i(0));
    let high = min(vec2i(floor((sprite.px + radius_px) / cell_px)), vec2i(grid.yz) - 1);
    for (var y = low.y; y <= high.y; y++) {
        for (var x = low.x; x <= high.x; x++) {
            let middle = (vec2f(vec2i(x, y)) + 0.5) * cell_px;
            let corner = abs(middle - sprite.px) + 0.5 * cell_px;
            if dot(corner, corner) <= radius_px * radius_px {
                atomicMax(&nearness[grid.x + u32(y) * grid.y + u32(x)], bits);
            }
        }
    }
}
