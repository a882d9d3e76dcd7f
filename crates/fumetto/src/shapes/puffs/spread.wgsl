// Makes the pyramid's levels agree: first what covers a cell covers its four children, then a cell is
// covered as near as the farthest of its children.

struct Level {
    index: u32,
}

@group(0) @binding(0) var<uniform> pyramid: Pyramid;
@group(0) @binding(1) var<uniform> level: Level;
@group(0) @binding(2) var<storage, read_write> nearness: array<u32>;

@compute @workgroup_size(16, 16)
fn down(@builtin(global_invocation_id) id: vec3u) {
    let grid = pyramid.level[level.index];
    if any(id.xy >= grid.yz) {
        return;
    }
    let parent = pyramid.level[level.index + 1u];
    let above = nearness[parent.x + (id.y / 2u) * parent.y + id.x / 2u];
    let at = grid.x + id.y * grid.y + id.x;
    nearness[at] = max(nearness[at], above);
}

@compute @workgroup_size(16, 16)
fn up(@builtin(global_invocation_id) id: vec3u) {
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
