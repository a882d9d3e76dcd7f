// What a triangle looks like where a pixel sees it.

struct MeshSurface {
    // Unit length, on the side that is seen.
    normal: vec3f,
    // Linear; straight alpha.
    colour: vec4f,
    part: u32,
    corners: vec3u,
    weights: vec3f,
    // 1 where the front is seen, else -1.
    side: f32,
}

// Weights of a triangle's corners where the ray from the camera meets it (Möller & Trumbore 1997); kept
// inside, because the middle of a pixel at an edge may lie just beside it.
fn corner_weights(a: vec3f, b: vec3f, c: vec3f, ray: vec3f) -> vec3f {
    let from_a = view.world_from_view[3].xyz - a;
    let p = cross(ray, c - a);
    let q = cross(from_a, b - a);
    let scale = dot(b - a, p);
    let uv = vec2f(dot(from_a, p), dot(ray, q)) / select(scale, 1e-30, abs(scale) < 1e-30);
    let weights = max(vec3f(1.0 - uv.x - uv.y, uv), vec3f(0.0));
    return weights / max(weights.x + weights.y + weights.z, 1e-20);
}

fn wrapped(at: f32, way: u32) -> f32 {
    let mirrored = 1.0 - abs(fract(0.5 * at) * 2.0 - 1.0);
    return select(select(at, mirrored, way == 1u), clamp(at, 0.0, 1.0), way == 2u);
}

// Colour of a texture at three places: the pixel's, and its neighbours' to the right and below, which say
// how finely it is seen.
fn texture_at(part: Part, uv: vec2f, right: vec2f, below: vec2f) -> vec4f {
    let at = vec2f(wrapped(uv.x, part.look & 3u), wrapped(uv.y, (part.look >> 2u) & 3u));
    return textureSampleGrad(textures, textures_sampler, at, max(part.texture, 0), right - uv, below - uv);
}

fn mesh_surface(number: u32, px: vec2f) -> MeshSurface {
    let triangle = triangles[number];
    let part = parts[triangle.part];
    let corners = triangle.corners;
    let a = vertices[corners.x];
    let b = vertices[corners.y];
    let c = vertices[corners.z];
    let ray = world_ray(px);
    let weights = corner_weights(a.position, b.position, c.position, ray);
    let normals = mat3x3f(octahedral_unpacked(a.normal), octahedral_unpacked(b.normal), octahedral_unpacked(c.normal));
    let behind = dot(cross(b.position - a.position, c.position - a.position), ray) > 0.0;
    let side = select(1.0, -1.0, behind);
    let normal = normalize(normals * weights) * side;
    if (part.look & NO_SOURCES) != 0u {
        return MeshSurface(normal, part.colour, triangle.part, corners, weights, side);
    }
    let sources_of = array(sources[corners.x], sources[corners.y], sources[corners.z]);
    let colours = mat3x4f(source_colour(sources_of[0]), source_colour(sources_of[1]), source_colour(sources_of[2]));
    var colour = part.colour * (colours * weights);
    if part.texture >= 0 {
        let uvs = mat3x2f(sources_of[0].uv, sources_of[1].uv, sources_of[2].uv);
        let right = corner_weights(a.position, b.position, c.position, world_ray(px + vec2f(1.0, 0.0)));
        let below = corner_weights(a.position, b.position, c.position, world_ray(px + vec2f(0.0, 1.0)));
        colour *= texture_at(part, uvs * weights, uvs * right, uvs * below);
    }
    return MeshSurface(normal, colour, triangle.part, corners, weights, side);
}

fn source_colour(source: Source) -> vec4f {
    return vec4f(unpack2x16float(source.colour.x), unpack2x16float(source.colour.y));
}
