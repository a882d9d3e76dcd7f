// Builds the pyramid from the depth layer: a cell is as near as its farthest pixel.

struct Level {
    index: u32,
}

@group(0) @binding(0) var<uniform> pyramid: Pyramid;
@group(0) @binding(1) var<uniform> level: Level;
@group(0) @binding(2) var<storage, read_write> nearness: array<u32>;
@group(0) @binding(3) var depth_layer: texture_depth_2d;

@compute @workgroup_size(16, 16)
fn pixels(@builtin(global_invocation_id) id: vec3u) {
    let grid = pyramid.level[0];
    if any(id.xy >= grid.yz) {
        return;
    }
    let side = u32(CELL_PX);
    let last = textureDimensions(depth_layer) - 1u;
    var farthest = 1.0;
    for (var i = 0u; i < side * side; i++) {
        let at = min(id.xy * side + vec2u(i % side, i / side), last);
        farthest = min(farthest, textureLoad(depth_layer, at, 0));
    }
    nearness[grid.x + id.y * grid.y + id.x] = bitcast<u32>(farthest);
}

@compute @workgroup_size(16, 16)
fn cells(@builtin(global_invocation_id) id: vec3u) {
    let grid = pyramid.level[level.index];
    if any(id.xy >= grid.yz) {
        return;
    }
    let child = pyramid.level[level.index - 1u];
    var farthest = 0xffffffffu;
    for (var corner = 0u; corner < 4u; corner++) {
        let at = min(id.xy * 2u + vec2u(corner & 1u, corner >> 1u), child.yz - 1u);
        farthest = min(farthest, nearness[child.x + at.y * child.y + at.x]);
    }
    nearness[grid.x + id.y * grid.y + id.x] = farthest;
}
