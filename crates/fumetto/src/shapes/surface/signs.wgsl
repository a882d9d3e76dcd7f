// Asks of every point of the active blocks whether it is inside. Only here: all that is decided later
// about how the surface hangs together is decided by these bits.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<Blob>;
@group(0) @binding(3) var<storage, read> starts: array<u32>;
@group(0) @binding(4) var<storage, read> entries: array<u32>;
@group(0) @binding(5) var<storage, read> active_blocks: array<u32>;
// A bit for each point of a block.
@group(0) @binding(6) var<storage, read_write> signs: array<vec2u>;

var<workgroup> bits: array<atomic<u32>, 2>;

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = group.y * groups.x + group.x;
    if slot >= lattice.active_blocks {
        return;
    }
    let block = active_blocks[slot];
    let corner = (lattice.first + block_place(lattice.blocks, block)) * BLOCK;
    let place = point_place(corner + vec3i(local_place(lane)), lattice.cell_m);
    if field_at(place, vec2u(starts[block], starts[block + 1u])).w > 0.0 {
        atomicOr(&bits[lane / 32u], 1u << (lane % 32u));
    }
    workgroupBarrier();
    if lane == 0u {
        signs[slot] = vec2u(atomicLoad(&bits[0]), atomicLoad(&bits[1]));
    }
}
