// Tells how large the mesh became, and draws just that.

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
@group(0) @binding(2) var<storage, read> vertex_starts: array<u32>;
@group(0) @binding(3) var<storage, read> triangle_starts: array<u32>;
@group(0) @binding(4) var<storage, read_write> counters: Counters;

@compute @workgroup_size(1)
fn main() {
    let vertices = vertex_starts[recipe.active_blocks];
    let triangles = triangle_starts[recipe.active_blocks];
    var overflow = lattice.overflow;
    overflow |= select(0u, VERTICES_LEFT_OUT, vertices > recipe.vertices);
    overflow |= select(0u, TRIANGLES_LEFT_OUT, triangles > recipe.triangles);
    let kept = min(triangles, recipe.triangles);
    counters = Counters(3u * kept, 1u, 3u * recipe.first_triangle, 0u, min(vertices, recipe.vertices), kept, overflow, 0u);
}
