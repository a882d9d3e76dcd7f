// Builds the pyramid from the depth layer: a cell is as near as its farthest pixel.

struct Level {
    index: u32,
}

@group(0) @binding(0) var<uniform> pyramid: Pyramid;
@group(0) @binding(1) var<uniform> level: Level;
@group(0) @binding(2) var<storage, read_write> nearness: array<u32>;
@group(0) @binding(3) var depth_layer: texture_depth_2d;
@group(0) @binding(4) var nearest: sampler;

@compute @workgroup_size(16, 16)
fn pixels(@builtin(global_invocation_id) id: vec3u) {
    let grid = pyramid.level[0];
    if any(id.xy >= grid.yz) {
        return;
    }
    // Four texels at once: those about the corner where they meet.
    let size = vec2f(textureDimensions(depth_layer));
    var farthest = vec4f(1.0);
    for (var corner = 0u; corner < 4u; corner++) {
        let at = vec2f(id.xy) * CELL_PX + 1.0 + 2.0 * vec2f(vec2u(corner & 1u, corner >> 1u));
        farthest = min(farthest, textureGather(depth_layer, nearest, at / size));
    }
    nearness[grid.x + id.y * grid.y + id.x] = bitcast<u32>(min(min(farthest.x, farthest.y), min(farthest.z, farthest.w)));
}

// A cell of any coarser level is as near as the farthest of the four below it.
fn reduce_cell(index: u32, cell: vec2u) {
    let grid = pyramid.level[index];
    let child = pyramid.level[index - 1u];
    var farthest = 0xffffffffu;
    for (var corner = 0u; corner < 4u; corner++) {
        let at = min(cell * 2u + vec2u(corner & 1u, corner >> 1u), child.yz - 1u);
        farthest = min(farthest, nearness[child.x + at.y * child.y + at.x]);
    }
    nearness[grid.x + cell.y * grid.y + cell.x] = farthest;
}

@compute @workgroup_size(16, 16)
fn cells(@builtin(global_invocation_id) id: vec3u) {
    if all(id.xy < pyramid.level[level.index].yz) {
        reduce_cell(level.index, id.xy);
    }
}

// One workgroup builds this level and all above it, which have few cells.
@compute @workgroup_size(256)
fn top(@builtin(local_invocation_index) lane: u32) {
    for (var index = level.index; index < pyramid.levels; index++) {
        let grid = pyramid.level[index];
        for (var cell = lane; cell < grid.y * grid.z; cell += 256u) {
            reduce_cell(index, vec2u(cell % grid.y, cell / grid.y));
        }
        storageBarrier();
    }
}
