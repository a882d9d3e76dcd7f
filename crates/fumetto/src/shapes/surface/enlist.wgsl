// Lists the blocks that the surface may cross, in the order of their numbers.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read_write> lattice: Lattice;
@group(0) @binding(2) var<storage, read> crossed: array<u32>;
// How many are crossed before each block.
@group(0) @binding(3) var<storage, read> slots: array<u32>;
// The first block of each region that is kept.
@group(0) @binding(4) var<storage, read> kept: array<vec3i>;
@group(0) @binding(5) var<storage, read_write> states: array<u32>;
@group(0) @binding(6) var<storage, read_write> active_blocks: array<ActiveBlock>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let block = (group.y * groups.x + group.x) * 256u + lane;
    if block < recipe.blocks && crossed[block] == 1u && slots[block] < recipe.active_blocks {
        active_blocks[slots[block]] = ActiveBlock(kept_place(block), block);
        states[block] = ACTIVE + slots[block];
    }
    if block == 0u {
        let wanted = slots[recipe.blocks];
        lattice.active_blocks = min(wanted, recipe.active_blocks);
        lattice.overflow |= select(0u, BLOCKS_LEFT_OUT, wanted > recipe.active_blocks);
    }
}
