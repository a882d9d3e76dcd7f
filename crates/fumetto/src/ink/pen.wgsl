// How one kind of edge of one object is drawn; an array of these, four to an object, goes with every frame.
struct Pen {
    // As it will be in the picture.
    colour: vec3f,
    // Of the whole object.
    opacity: f32,
    // The larger of the two widths counts.
    width_px: f32,
    width_m: f32,
    // Lengths that are drawn and left out in turn; 0 where lines are whole.
    dash_px: vec2f,
    // Length of the shortest line that is kept.
    shortest_px: f32,
    // How wide lines are where the light thins them.
    thinnest_px: f32,
    // Bit 0: draws. Bit 1: along the edges of a model, or contours of a surface, of this cel. Bit 2: dashes what is hidden.
    // Bit 3: along these as strokes.
    flags: u32,
    // Share of a line's width that goes where it faces the light.
    lit_thinning: f32,
}

const DRAWS: u32 = 1u;
const FOLLOWS_EDGES: u32 = 2u;
const DASHES_HIDDEN: u32 = 4u;
const HAS_STROKES: u32 = 8u;

// Pens that a frame may have: as many as the ink layer tells apart. Also in `pen.rs`.
const MAX_PENS: u32 = 256u;

// Kinds of edges, and how many there are.
const SILHOUETTE: u32 = 0u;
const CREASE: u32 = 1u;
const BOUNDARY: u32 = 2u;
const MATERIAL: u32 = 3u;
const KINDS: u32 = 4u;

// Share of a pen's width under which a line that the light thins is gone: at a hair's width it would break.
const FINEST: f32 = 0.25;

// Number of a pen. The ink layer holds it + 1, and 0 where there is no ink.
fn pen_number(object: u32, kind: u32) -> u32 {
    return KINDS * object + kind;
}
