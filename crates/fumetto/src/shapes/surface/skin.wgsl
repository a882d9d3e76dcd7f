// Lattice edges that the surface crosses.

// A vertex keeps so much of an edge from its ends: vertices around a lattice point that the surface
// passes closely would else be the corners of slivers. On a sphere, angles of less than 20° then go from
// one triangle in four to one in a hundred.
const CLEAR: f32 = 0.4;
// No vertex is farther from the middle of its edge, in cells: particles that do not reach so far are not
// asked.
const AROUND: f32 = 1.0;
// Gradients below this lead nowhere.
const FLAT: f32 = 1e-20;

// A lattice edge.
struct Edge {
    start: vec3f,
    along: vec3f,
    // Whether its start is inside.
    inside: bool,
}

// A block that has vertices.
struct Skin {
    corner: vec3i,
    crossed: Crossed,
    // Its list.
    list: vec2u,
}

fn skin_of(slot: u32) -> Skin {
    let own = crossed[slot];
    return Skin(active_blocks[slot].place * BLOCK, unpacked_crossed(own), own.fours_list.zw);
}

fn edge_of_vertex(skin: Skin, index: u32, cell_m: f32) -> Edge {
    let block = skin.crossed;
    var axis = 0u;
    var left = index;
    var points = block.x;
    if left >= bits_of(block.x) {
        left -= bits_of(block.x);
        axis = 1u;
        points = block.y;
        if left >= bits_of(block.y) {
            left -= bits_of(block.y);
            axis = 2u;
            points = block.z;
        }
    }
    let point = nth_point(points, left);
    let start = point_place(skin.corner + vec3i(local_place(point)), cell_m);
    let along = vec3f(vec3u(axis) == vec3u(0u, 1u, 2u)) * cell_m;
    return Edge(start, along, has(block.inside, point) == 1u);
}
