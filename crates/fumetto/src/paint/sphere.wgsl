// The radius of a volume in any direction. Uses `directions`, `patches`, `vertices` and `icosahedron` of the
// program that it is part of.

// The same for all volumes.
struct Icosahedron {
    // Of each face, what turns a direction into shares of its corners: the rows of a matrix.
    shares: array<array<vec4f, 3>, 20>,
    // By the sort of a direction, its face.
    faces: array<vec4u, 8>,
}

// Vertices that weigh in a triangle.
const PATCH: u32 = 12u;
const NO_VERTEX: u32 = 0xffffffffu;

const PHI: f32 = 1.618034;

// The face of an icosahedron that a direction meets: the one to whose middle it is nearest. Their middles are four
// kinds of places, mirrored in the planes between the axes.
fn face_of(direction: vec3f) -> u32 {
    let a = abs(direction);
    let near = vec4f(a.x + a.y + a.z, a.x / PHI + a.z * PHI, a.x * PHI + a.y / PHI, a.y * PHI + a.z / PHI);
    let first = select(0u, 1u, near.y > near.x);
    let second = select(2u, 3u, near.w > near.z);
    let kind = select(first, second, max(near.z, near.w) > max(near.x, near.y));
    let signs = select(vec3u(0u), vec3u(1u, 2u, 4u), direction < vec3f(0.0));
    let sort = kind * 8u + signs.x + signs.y + signs.z;
    return icosahedron.faces[sort / 4u][sort % 4u];
}

// The triangle that a direction meets, of those of an icosahedron whose edges are cut into pieces.
fn triangle_of(direction: vec3f, pieces: u32) -> u32 {
    let face = face_of(direction);
    let shares = vec2f(
        dot(icosahedron.shares[face][0].xyz, direction),
        dot(icosahedron.shares[face][1].xyz, direction),
    );
    let all = shares.x + shares.y + dot(icosahedron.shares[face][2].xyz, direction);
    let p = clamp(shares / all, vec2f(0.0), vec2f(1.0)) * f32(pieces);
    let i = min(u32(p.x), pieces - 1u);
    let j = min(u32(p.y), pieces - 1u - i);
    let on_its_head = p.x - f32(i) + p.y - f32(j) > 1.0 && i + j + 1u < pieces;
    return face * pieces * pieces + i * (2u * pieces - i) + 2u * j + select(0u, 1u, on_its_head);
}

// Adds what a vertex of a patch weighs in a direction: the radius times its weight, and the weight.
fn weigh(body: Body, number: u32, direction: vec3f, sum: vec2f) -> vec2f {
    let vertex = patches[number];
    if vertex == NO_VERTEX {
        return sum;
    }
    let known = directions[body.first_direction + vertex];
    let away = direction - known.xyz;
    let near = max(1.0 - dot(away, away) * known.w, 0.0);
    let weight = near * near * near;
    return sum + vec2f(weight * vertices[body.first_vertex + vertex].x, weight);
}

// In metres; `direction` is of unit length. Written out, and not a loop: see `mask.wgsl`.
fn radius_of(body: Body, direction: vec3f) -> f32 {
    let first = body.first_patch + triangle_of(direction, body.pieces) * PATCH;
    var sum = weigh(body, first, direction, vec2f(0.0));
    sum = weigh(body, first + 1u, direction, sum);
    sum = weigh(body, first + 2u, direction, sum);
    sum = weigh(body, first + 3u, direction, sum);
    sum = weigh(body, first + 4u, direction, sum);
    sum = weigh(body, first + 5u, direction, sum);
    sum = weigh(body, first + 6u, direction, sum);
    sum = weigh(body, first + 7u, direction, sum);
    sum = weigh(body, first + 8u, direction, sum);
    sum = weigh(body, first + 9u, direction, sum);
    sum = weigh(body, first + 10u, direction, sum);
    sum = weigh(body, first + 11u, direction, sum);
    return sum.x / max(sum.y, 1e-12);
}
