// The vortices of one object in a tree of pairs: leaves in the order of a Hilbert curve, and above them nodes
// that stand for ever more of them. Node 1 is the root, the two below node n are 2 n and 2 n + 1, and numbers
// from `places` on are leaves.

// What is summed over the vortices.
struct Tree {
    // Vortices, and places for them in the tree: a power of two.
    count: u32,
    places: u32,
    // In each ring.
    segments: u32,
    // 1: they are taken where they are in the middle of the step.
    halfway: u32,
    // In m²/s.
    viscosity: f32,
    // What a node's spread is multiplied with to tell how near it may be.
    opening: f32,
    // The lowest level of nodes that is made of what lies below.
    level: u32,
    pad: u32,
}

struct Leaf {
    position: vec3f,
    // The square of its core's radius.
    core2: f32,
    // Circulation times the piece of line: its vorticity times its volume.
    strength: vec3f,
    pad: u32,
}

struct Node {
    // Of the strengths' amounts.
    center: vec3f,
    // It can stand for what is below it at this distance and beyond; below zero: there is nothing in it.
    opening: f32,
    // Sum of strengths.
    strength: vec3f,
    // Mean of the squares of cores' radii.
    core2: f32,
    // Rows of the sum of strength ⊗ (position - center).
    dipole_x: vec3f,
    // Sum of the strengths' amounts.
    weight: f32,
    dipole_y: vec3f,
    // The farthest vortex from the centre is no farther than this.
    reach: f32,
    dipole_z: vec3f,
    // Sum over amount × (square of the distance from the centre + |difference of core2 from the mean|).
    spread: f32,
}
