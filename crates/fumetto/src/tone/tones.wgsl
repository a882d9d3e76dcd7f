// How one object turns light into colour, beyond its ramp; a list of these, by the object's number, lies in
// a uniform buffer, so that it takes none of the few storage buffers.
struct ToneStyle {
    // Colours that are drawn as they are; encoded.
    highlight_colour: vec3f,
    // From this value of Blinn and Phong's term upward; out of reach where there is none.
    highlight_from: f32,
    rim_colour: vec3f,
    rim_from: f32,
    // For shading from cool to warm; encoded.
    cool: vec3f,
    alpha: f32,
    warm: vec3f,
    beta: f32,
    // What the object is painted with, for the same.
    paint: vec3f,
    gloss: f32,
    // What a ramp's rows run along.
    focus: vec3f,
    axis: u32,
    // Where along it the top row and the bottom row are; for `FACING` the exponent.
    axis_ends: vec2f,
    first_row: i32,
    row_count: i32,
    // Cosine under which there is a rim; 0 where there is none.
    rim_width: f32,
    exaggerate_amount: f32,
    exaggerate_contrast: f32,
    exaggerate_scales: i32,
    material_steps: f32,
    is_gooch: u32,
}

const AXIS_NONE: u32 = 0u;
const AXIS_DEPTH: u32 = 1u;
const AXIS_FACING: u32 = 2u;
const AXIS_FOCUS: u32 = 3u;
