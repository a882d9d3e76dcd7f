// Puts a vertex where the surface crosses a lattice edge, with care, one at a time: what `vertices.wgsl` left.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> blobs: array<PackedBlob>;
@group(0) @binding(3) var<storage, read> entries: array<u32>;
@group(0) @binding(4) var<storage, read> active_blocks: array<ActiveBlock>;
@group(0) @binding(5) var<storage, read> crossed: array<PackedCrossed>;
// How many vertices, triangles and chunks there are before each block.
@group(0) @binding(6) var<storage, read> mesh_starts: array<vec4u>;
// As `Hard` of `hard.wgsl`: workgroups, how many there are, and these.
@group(0) @binding(7) var<storage, read> hard: array<u32>;
@group(0) @binding(8) var<storage, read_write> vertices: array<Vertex>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) invocation: vec3u) {
    let units = units();
    if invocation.x >= hard[3] {
        return;
    }
    let vertex = hard[4u + invocation.x];
    let slot = vertex >> 8u;
    let index = vertex & 0xffu;
    let skin = skin_of(slot);
    let edge = edge_of_vertex(skin, index, units.cell_m);
    let near = near(edge.start + 0.5 * edge.along, AROUND * units.cell_m, skin.list, units);
    let sample = surface_near(edge, near);
    vertices[mesh_starts[slot].x + index] = Vertex(sample.place, octahedral_packed(outward(sample.field, edge)));
}
