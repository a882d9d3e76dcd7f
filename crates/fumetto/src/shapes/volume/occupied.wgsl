// Finds the blocks of the grid in which there is matter, those included that only take part in sampling
// between cells: rays leap over all others.

@group(0) @binding(0) var<storage, read> grid: VolumeGrid;
@group(0) @binding(1) var<storage, read_write> occupied: array<u32>;
@group(0) @binding(2) var density: texture_3d<f32>;

@compute @workgroup_size(4, 4, 4)
fn main(@builtin(global_invocation_id) block: vec3u) {
    let blocks = (grid.cells + BLOCK - 1u) / BLOCK;
    if any(block >= blocks) {
        return;
    }
    let low = max(block * BLOCK, vec3u(1u)) - 1u;
    let high = min((block + 1u) * BLOCK + 1u, grid.cells);
    var found = 0u;
    for (var z = low.z; z < high.z && found == 0u; z++) {
        for (var y = low.y; y < high.y && found == 0u; y++) {
            for (var x = low.x; x < high.x; x++) {
                found |= u32(textureLoad(density, vec3u(x, y, z), 0).a > 0.0);
            }
        }
    }
    occupied[block_number(block, grid.cells)] = found;
}
