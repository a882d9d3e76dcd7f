// Where on a model a line may run: an edge with the triangles at it, or a triangle in which the surface may turn
// away from the viewer.
struct Candidate {
    // Vertices of the triangle on the left: the edge's two, then the one opposite.
    left: vec3u,
    // Bits of kinds of edges, and what is below; in bits 16..32, the object.
    bits: u32,
    // On the right: its vertices at the same places, in the same order.
    right: vec3u,
    pad: u32,
}

// A contour may cross the triangle on the left.
const CONTOUR: u32 = 1u;
// Normals differ from side to side.
const HARD: u32 = 16u;
// The triangles wind against each other.
const FLIPPED: u32 = 32u;
// Is not seen from behind.
const LEFT_ONE_SIDED: u32 = 64u;
const RIGHT_ONE_SIDED: u32 = 128u;
// There is a triangle on the right.
const PAIRED: u32 = 256u;

fn candidate_object(candidate: Candidate) -> u32 {
    return candidate.bits >> 16u;
}
