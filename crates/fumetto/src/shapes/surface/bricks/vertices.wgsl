// Puts a vertex where the surface of a file's density crosses a lattice edge. `vertices.wgsl` and `careful.wgsl` say the
// same of particles.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var linear: sampler;
@group(0) @binding(6) var<storage, read> active_blocks: array<ActiveBlock>;
@group(0) @binding(7) var<storage, read> crossed: array<PackedCrossed>;
// How many vertices, triangles and chunks there are before each block.
@group(0) @binding(8) var<storage, read> mesh_starts: array<vec4u>;
@group(0) @binding(9) var<storage, read_write> vertices: array<Vertex>;

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let near = Near(units());
    let capacity = recipe.vertices;
    let blocks = lattice.active_blocks;
    let number = (group.y * groups.x + group.x) * 64u + lane;
    if number >= mesh_starts[recipe.active_blocks].z {
        return;
    }
    let chunk = chunk_at(number, blocks);
    let skin = skin_of(chunk.slot);
    let first = IN_CHUNK * chunk.index;
    let room = min(vertices_of(skin.crossed), max(capacity, chunk.first_vertex) - chunk.first_vertex);
    for (var index = first; index < min(first + IN_CHUNK, room); index++) {
        let edge = edge_of_vertex(skin, index, near.units.cell_m);
        let sample = surface_near(edge, near);
        vertices[chunk.first_vertex + index] = Vertex(sample.place, octahedral_packed(outward(sample.field, edge)));
    }
}
