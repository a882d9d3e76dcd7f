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

// How closely the shading of a triangle's corners has to follow their places along the light, as a correlation,
// for the triangle to count as one of a rounded hill.
const ROUND: f32 = 0.9;

// How the shading of an unlit triangle's corners, `lit`, makes it stand to the light.
//
// Facets along the border of light stand a little this way and that, and would throw saw teeth over it. So on a
// hill, which gets darker on the way from the light, shadows begin where all of a facet is dark by its shading:
// whatever lies beyond is dark, too. Anywhere else, as in a valley, they begin with the facets, and what is lit of
// these by its shading lies in shadow.
fn facing_of(along: vec3f, lit: vec3f) -> u32 {
    if all(lit <= vec3f(0.0)) {
        return BACKWARD;
    }
    let steps = along - along.yzx;
    let changes = lit - lit.yzx;
    let is_hill = dot(steps, changes) >= ROUND * length(steps) * length(changes);
    return select(BACKWARD | IN_VALLEY, 0u, is_hill);
}

@compute @workgroup_size(256)
fn list_caps(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = (group.y * groups.x + group.x) * 256u + lane;
    if 3u * index >= draw[0] {
        return;
    }
    let number = draw[2] / 3u + index;
    let light = lights.light[volumes.light];
    let corners = triangles[number].corners;
    let a = vertices[corners.x];
    let b = vertices[corners.y];
    let c = vertices[corners.z];
    let normal = cross(b.position - a.position, c.position - a.position);
    let toward = light.vector - a.position * light.is_point;
    var facing = 0u;
    if dot(normal, toward) < -EDGE_ON * length(normal) * length(toward) {
        facing = facing_of(toward * mat3x3f(a.position, b.position, c.position), vec3f(
            dot(octahedral_unpacked(a.normal), toward),
            dot(octahedral_unpacked(b.normal), light.vector - b.position * light.is_point),
            dot(octahedral_unpacked(c.normal), light.vector - c.position * light.is_point),
        ));
    }
    facings[number] = facing;
    if facing != 0u {
        add_cap(number, true, dot(normal, view.world_from_view[3].xyz - a.position) <= 0.0);
    }
}

@compute @workgroup_size(256)
fn list_sides(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = (group.y * groups.x + group.x) * 256u + lane;
    let first = draw[2] / 3u;
    if 3u * index >= draw[0] || (facings[first + index] & BACKWARD) == 0u {
        return;
    }
    let corners = triangles[first + index].corners;
    var ends = array(corners.yx, corners.zy, corners.xz);
    for (var edge = 0u; edge < 3u; edge++) {
        let beyond = adjacent[3u * index + edge];
        if beyond >= draw[0] / 3u || (facings[first + beyond] & BACKWARD) == 0u {
            add_side(ends[edge]);
        }
    }
}
