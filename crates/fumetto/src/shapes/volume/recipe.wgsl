// What is made of an object's puffs, and how it is looked at.
struct Recipe {
    // The object's puffs in the list of all.
    first: u32,
    count: u32,
    // 1 where density falls from the middle to the surface.
    is_linear: u32,
    // Share of the radius over which the density rises inward.
    edge: f32,
    // What displaces the surface, in radii.
    amplitude: f32,
    frequency: f32,
    octaves: u32,
    persistence: f32,
    lacunarity: f32,
    seed: u32,
    // 1 where each octave's absolute value counts.
    billow: u32,
    // 1 where the grid's cells come in steps.
    moves: u32,
    // Where the noise has drifted to, in radii.
    drift: vec3f,
    colour_count: u32,
    // Per metre.
    extinction: f32,
    glow: f32,
    soft: f32,
    surface: f32,
    // In metres; zero where it is in cells.
    step_m: f32,
    // Whether the object shadows itself.
    shadows: u32,
    step_cells: f32,
    // The opacity from which on it keeps light from other things; zero where it does not.
    murk: f32,
    // Along the side of a square that one line of sight is followed for.
    pixels: f32,
    // Linear.
    colours: array<vec4f, 8>,
}
