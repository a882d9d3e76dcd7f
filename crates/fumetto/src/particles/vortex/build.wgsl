// Makes leaves of vortices, and nodes of what is below them.

@group(0) @binding(0) var<uniform> tree: Tree;
@group(0) @binding(1) var<storage, read> vortices: array<Vortex>;
@group(0) @binding(2) var<storage, read> halfway: array<vec4f>;
@group(0) @binding(3) var<storage, read> keys: array<vec2u>;
@group(0) @binding(4) var<storage, read_write> leaves: array<Leaf>;
@group(0) @binding(5) var<storage, read_write> nodes: array<Node>;

// Levels that one workgroup makes: its 256 lanes have twice as many leaves below them.
const LEVELS: u32 = 8u;
// A piece of line gets no more than so many times longer. In air its core would get thinner meanwhile, until
// friction ended it; ours keeps its width, so the piece would get ever stronger.
const STRETCH: f32 = 8.0;
// Cores overlap along the line, or it falls apart into dots: their radius is at least this share of a piece.
// Vortex methods converge where cores overlap (Winckelmans & Leonard 1993).
const OVERLAP: f32 = 0.6;
// In the last share of its life a ring dies away, so that the air around does not jolt.
const FADE: f32 = 0.25;
// A core of no width would divide by zero; in m².
const LEAST_CORE2: f32 = 1e-8;

fn position_of(slot: u32) -> vec3f {
    return select(vortices[slot].position, halfway[slot].xyz, tree.halfway == 1u);
}

// The line between the middles of the pieces on both sides: as the ring gets longer, so does it. This is how
// vortices are stretched (Helmholtz: vortex lines are carried with the air), and all pieces of a ring always
// add up to zero (cf. Angelidis & Neyret 2005, "Simulation of smoke based on vortex filament primitives").
fn piece_of(slot: u32) -> vec3f {
    let ring = slot / tree.segments * tree.segments;
    let nth = slot - ring;
    let next = ring + (nth + 1u) % tree.segments;
    let last = ring + (nth + tree.segments - 1u) % tree.segments;
    return 0.5 * (position_of(next) - position_of(last));
}

@compute @workgroup_size(256)
fn make_leaves(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let place = group.x * 256u + lane;
    let slot = keys[place].y;
    if slot >= tree.count || !spins(vortices[slot]) {
        leaves[place] = Leaf(vec3f(0.0), 1.0, vec3f(0.0), 0u);
        return;
    }
    let vortex = vortices[slot];
    var piece = piece_of(slot);
    let length = length(piece);
    piece *= min(1.0, STRETCH * vortex.length / max(length, 1e-20));
    let overlap = OVERLAP * length;
    // Lines spread as lines of vorticity do in a viscous fluid (Leonard 1980, "core spreading").
    let spread2 = vortex.core * vortex.core + 4.0 * tree.viscosity * max(vortex.age, 0.0);
    let left = smoothstep(0.0, FADE, 1.0 - vortex.age / vortex.life);
    let core2 = max(max(spread2, overlap * overlap), LEAST_CORE2);
    leaves[place] = Leaf(position_of(slot), core2, vortex.circulation * left * piece, 0u);
}

fn node_of(leaf: Leaf) -> Node {
    let zero = vec3f(0.0);
    let weight = length(leaf.strength);
    let opening = select(0.0, -1.0, weight == 0.0);
    return Node(leaf.position, opening, leaf.strength, leaf.core2, zero, weight, zero, 0.0, zero, 0.0);
}

fn below(at: u32) -> Node {
    if at >= tree.places {
        return node_of(leaves[at - tree.places]);
    }
    return nodes[at];
}

// Moments about another centre: the parallel axis theorem.
fn merged(a: Node, b: Node) -> Node {
    if a.weight == 0.0 {
        return b;
    }
    if b.weight == 0.0 {
        return a;
    }
    let weight = a.weight + b.weight;
    let center = (a.weight * a.center + b.weight * b.center) / weight;
    let core2 = (a.weight * a.core2 + b.weight * b.core2) / weight;
    let from_a = a.center - center;
    let from_b = b.center - center;
    let spread = a.spread + a.weight * (dot(from_a, from_a) + abs(a.core2 - core2))
        + b.spread + b.weight * (dot(from_b, from_b) + abs(b.core2 - core2));
    let reach = max(length(from_a) + a.reach, length(from_b) + b.reach);
    // The series' remainder is at most 3 spread / (weight (distance - reach)²) of the sum of all amounts
    // (Salmon & Warren 1994, "Skeletons from the treecode closet"): `opening` is √(3 / error).
    return Node(
        center,
        reach + tree.opening * sqrt(spread / weight),
        a.strength + b.strength,
        core2,
        a.dipole_x + b.dipole_x + a.strength.x * from_a + b.strength.x * from_b,
        weight,
        a.dipole_y + b.dipole_y + a.strength.y * from_a + b.strength.y * from_b,
        reach,
        a.dipole_z + b.dipole_z + a.strength.z * from_a + b.strength.z * from_b,
        spread,
    );
}

// A workgroup makes `LEVELS` levels of nodes above 256 of what is below, or the few that are left.
@compute @workgroup_size(128)
fn make_nodes(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    for (var up = 0u; up < LEVELS; up++) {
        let row = tree.places >> (tree.level + up);
        let each = 128u >> up;
        let nth = group.x * each + lane;
        if lane < each && nth < row {
            let at = row + nth;
            nodes[at] = merged(below(2u * at), below(2u * at + 1u));
        }
        storageBarrier();
    }
}
