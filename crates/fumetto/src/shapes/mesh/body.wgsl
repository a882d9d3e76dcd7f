// Draws triangles into the depth and id layers: what the nearest one looks like is worked out once per pixel
// afterwards. Vertices are pulled, so that each triangle's number is known without any optional feature.

@group(0) @binding(1) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(2) var<storage, read> triangles: array<Triangle>;

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) @interpolate(flat) id: u32,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let number = index / 3u;
    let position = vertices[triangles[number].corners[index % 3u]].position;
    return Corner(clip_from_world(position), TRIANGLE_BIT | number);
}

@fragment
fn fragment(corner: Corner) -> @location(0) u32 {
    return corner.id;
}
