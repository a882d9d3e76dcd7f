// How deep the triangles at a line are. Uses `vertices` of the program that it is part of.

fn in_view(position: vec3f) -> vec3f {
    return (view.view_from_world * vec4f(position, 1.0)).xyz;
}

// The depth of a triangle's plane, over the ray of a pixel.
fn depth_plane(corners: vec3u) -> vec3f {
    let a = in_view(vertices[corners.x].position);
    let normal = cross(in_view(vertices[corners.y].position) - a, in_view(vertices[corners.z].position) - a);
    let offset = dot(normal, a);
    // Seen edge-on, it says nothing.
    return select(vec3f(0.0), view.near * normal / offset, abs(offset) > 1e-6 * length(normal) * length(a));
}

// Depths of a triangle's farthest and nearest corner.
fn depth_range(corners: vec3u) -> vec2f {
    let a = depth_of(-in_view(vertices[corners.x].position).z);
    let b = depth_of(-in_view(vertices[corners.y].position).z);
    let c = depth_of(-in_view(vertices[corners.z].position).z);
    return vec2f(min(a, min(b, c)), max(a, max(b, c)));
}
