// Finds the faces of the shadow volumes of a closed surface that the device has made. As of models, it is the
// triangles that look away from the light that cast; here it is known which triangle lies beyond each edge.

@group(0) @binding(1) var<uniform> lights: Lights;
@group(0) @binding(2) var<uniform> volumes: Volumes;
@group(0) @binding(3) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(4) var<storage, read> triangles: array<Triangle>;
// Three for each of the surface's triangles, counted from its first.
@group(0) @binding(5) var<storage, read> adjacent: array<u32>;
// Arguments of the surface's own draw: how many vertices, how many times, the first.
@group(0) @binding(6) var<storage, read> draw: array<u32, 3>;

@compute @workgroup_size(256)
fn list_caps(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = (group.y * groups.x + group.x) * 256u + lane;
    if 3u * index >= draw[0] {
        return;
    }
    let number = draw[2] / 3u + index;
    let light = lights.light[volumes.light];
    let corners = triangles[number].corners;
    let a = vertices[corners.x].position;
    let normal = cross(vertices[corners.y].position - a, vertices[corners.z].position - a);
    let toward = light.vector - a * light.is_point;
    let lit = dot(normal, toward);
    let casts = lit < -EDGE_ON * length(normal) * length(toward);
    facings[number] = select(0u, BACKWARD, casts);
    if casts {
        add_cap(number, true, dot(normal, view.world_from_view[3].xyz - a) <= 0.0);
    }
}

@compute @workgroup_size(256)
fn list_sides(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = (group.y * groups.x + group.x) * 256u + lane;
    let first = draw[2] / 3u;
    if 3u * index >= draw[0] || facings[first + index] != BACKWARD {
        return;
    }
    let corners = triangles[first + index].corners;
    var ends = array(corners.yx, corners.zy, corners.xz);
    for (var edge = 0u; edge < 3u; edge++) {
        let beyond = adjacent[3u * index + edge];
        if beyond >= draw[0] / 3u || facings[first + beyond] != BACKWARD {
            add_side(ends[edge]);
        }
    }
}
