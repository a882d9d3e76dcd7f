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
    // Normals go by the cofactors, which also hold where a scale is 0 or negative.
    let normal = octahedral_unpacked(source.normal);
    let x = cross(world[1].xyz, world[2].xyz);
    let y = cross(world[2].xyz, world[0].xyz);
    let z = cross(world[0].xyz, world[1].xyz);
    let mirrored = select(1.0, -1.0, dot(world[0].xyz, x) < 0.0);
    let turned = mirrored * (x * normal.x + y * normal.y + z * normal.z);
    vertices[index] = Vertex((world * vec4f(source.position, 1.0)).xyz, octahedral_packed(turned));
}
