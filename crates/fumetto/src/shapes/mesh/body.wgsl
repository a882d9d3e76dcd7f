// Draws triangles into the depth and id layers: what the nearest one looks like is worked out once per pixel
// afterwards. Vertices are pulled, so that each triangle's number is known without any optional feature.

// Whether textures cut holes.
override HAS_HOLES: bool = false;

@group(0) @binding(1) var<storage, read> sources: array<Source>;
@group(0) @binding(2) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(3) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(4) var<storage, read> parts: array<Part>;
@group(0) @binding(5) var textures: texture_2d_array<f32>;
@group(0) @binding(6) var textures_sampler: sampler;

struct Corner {
    // The caps of shadow volumes lie exactly on it.
    @builtin(position) @invariant position: vec4f,
    @location(0) @interpolate(flat) id: u32,
}

// Whether a triangle is seen from the side that its material leaves out.
fn is_seen_from_behind(triangle: Triangle) -> bool {
    let a = vertices[triangle.corners.x].position;
    let b = vertices[triangle.corners.y].position;
    let c = vertices[triangle.corners.z].position;
    return dot(cross(b - a, c - a), view.world_from_view[3].xyz - a) <= 0.0;
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let number = index / 3u;
    let triangle = triangles[number];
    let id = TRIANGLE_BIT | number;
    if (parts[triangle.part].look & DOUBLE_SIDED) == 0u && is_seen_from_behind(triangle) {
        // Before the near plane, where all three corners meet.
        return Corner(vec4f(0.0, 0.0, 2.0, 1.0), id);
    }
    return Corner(clip_from_world(vertices[triangle.corners[index % 3u]].position), id);
}

@fragment
fn fragment(corner: Corner) -> @location(0) u32 {
    if HAS_HOLES {
        let surface = mesh_surface(corner.id & ~TRIANGLE_BIT, corner.position.xy);
        if surface.colour.a < f32(parts[surface.part].look >> 16u) / 65535.0 {
            discard;
        }
    }
    return corner.id;
}
