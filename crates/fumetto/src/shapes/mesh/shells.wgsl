// What shadow volumes of triangles are made of.

// Where two triangles meet, or one ends.
struct Edge {
    // Numbers of vertices.
    ends: vec2u,
    // Numbers of triangles. The first runs from the first end to the second; the second may be missing.
    sides: vec2u,
}

const NO_SIDE: u32 = 0xffffffffu;

// On the second triangle: it runs as the first does.
const SAME_WAY: u32 = 0x80000000u;

// A triangle throws a shadow when light falls on its front, and when it falls on its back.
const LIT_CASTS: u32 = 1u;
const UNLIT_CASTS: u32 = 2u;
