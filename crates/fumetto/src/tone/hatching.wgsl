// How one object is hatched; a list of these, by the object's number, lies in a uniform buffer.
struct HatchStyle {
    // Across strokes, of unit length, in the coordinates that strokes stay in: of each layer; or of those that run
    // one way each, among which the form chooses.
    axes: array<vec4f, 8>,
    // Encoded.
    colour: vec3f,
    // Amounts of light: no strokes from here on, and most strokes.
    light_from: f32,
    light_full: f32,
    swell: f32,
    // Tones that strokes tell apart, or 0.
    levels: f32,
    layers: u32,
    // Of a stroke at its widest, and from one to the next: of two the larger counts. In samples, and in metres.
    width_px: f32,
    width_m: f32,
    spacing_px: f32,
    spacing_m: f32,
    // 0 where strokes never end.
    length_px: f32,
    gaps: f32,
    wobble_px: f32,
    tooth: f32,
    // Samples to a pixel of the style.
    scale: f32,
    // What strokes stay with.
    follow: u32,
    seed: u32,
    // Bit 0: samples are all stroke or none. Bit 1: the form is smoothed. Bit 2: it chooses among the axes.
    look: u32,
    // Angle between layers, where the form chooses.
    cross: f32,
}

const FOLLOW_NOTHING: u32 = 0u;
const FOLLOW_FORM: u32 = 1u;
const FOLLOW_OBJECT: u32 = 2u;
const FOLLOW_SCREEN: u32 = 3u;

const IS_HARD: u32 = 1u;
const IS_SMOOTHED: u32 = 2u;
const IS_CURVED: u32 = 4u;

// Axes among which a form chooses.
const AXES: u32 = 8u;
