// Takes models' vertices to where their parts stand at the moment that is drawn.

@group(0) @binding(0) var<storage, read> sources: array<Source>;
@group(0) @binding(1) var<storage, read> parts: array<Part>;
@group(0) @binding(2) var<storage, read_write> vertices: array<Vertex>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) local: u32) {
    let index = (group.y * groups.x + group.x) * 256u + local;
    if index >= arrayLength(&sources) {
        return;
    }
    let source = sources[index];
    let world = parts[source.part].world_from_part;
    let turned = turned_normal(world, octahedral_unpacked(source.normal));
    vertices[index] = Vertex((world * vec4f(source.position, 1.0)).xyz, octahedral_packed(turned));
}
