// Asks of every point of the active blocks whether it is inside, of a file's density. `signs.wgsl` says the same of
// particles.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var linear: sampler;
@group(0) @binding(6) var<storage, read> active_blocks: array<ActiveBlock>;
// A bit for each point of a block.
@group(0) @binding(7) var<storage, read_write> signs: array<vec2u>;

@compute @workgroup_size(32)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let cell_m = lattice.cell_m;
    let slot = (group.y * groups.x + group.x) * 32u + lane;
    if slot >= lattice.active_blocks {
        return;
    }
    let first = active_blocks[slot].place * BLOCK;
    var bits = vec2u(0u);
    for (var point = 0u; point < 64u; point++) {
        let place = point_place(first + vec3i(local_place(point)), cell_m);
        let density = density_of(sample_at(cell_of(place)));
        let field = field_of(vec4f(vec3f(0.0), density), place);
        bits[point / 32u] |= select(0u, 1u << (point % 32u), field.w > 0.0);
    }
    signs[slot] = bits;
}
