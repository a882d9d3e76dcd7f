// Tells how large the mesh becomes, writes just that, and draws it.

struct Counters {
    // Arguments of an indirect draw that pulls vertices: three for each triangle.
    draw_vertices: u32,
    draw_instances: u32,
    draw_first_vertex: u32,
    draw_first_instance: u32,
    vertices: u32,
    triangles: u32,
    // What did not fit: bits of `lattice.wgsl`.
    overflow: u32,
    pad: u32,
}

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
// How many vertices, triangles and chunks there are before each block.
@group(0) @binding(2) var<storage, read> mesh_starts: array<vec4u>;
@group(0) @binding(3) var<storage, read_write> counters: Counters;
// Workgroups for kernels that take sixty-four chunks each.
@group(0) @binding(4) var<storage, read_write> groups: array<u32, 3>;
@group(0) @binding(5) var<storage, read_write> hard: Hard;

@compute @workgroup_size(1)
fn main() {
    let total = mesh_starts[recipe.active_blocks];
    let vertices = total.x;
    let triangles = total.y;
    var overflow = lattice.overflow;
    overflow |= select(0u, VERTICES_LEFT_OUT, vertices > recipe.vertices);
    overflow |= select(0u, TRIANGLES_LEFT_OUT, triangles > recipe.triangles);
    let kept = min(triangles, recipe.triangles);
    counters = Counters(3u * kept, 1u, 3u * recipe.first_triangle, 0u, min(vertices, recipe.vertices), kept, overflow, 0u);
    groups = folded((total.z + 63u) / 64u);
    atomicStore(&hard.groups_x, 0u);
    hard.groups_y = 1u;
    hard.groups_z = 1u;
    atomicStore(&hard.count, 0u);
}
