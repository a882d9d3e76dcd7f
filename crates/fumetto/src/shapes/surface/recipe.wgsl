// What is made of an object's puffs, and how much room there is for it.
struct Recipe {
    // The object's puffs in the list of all.
    first: u32,
    count: u32,
    // Both multiply what puffs bring along.
    radius_scale: f32,
    mass_scale: f32,
    // T of equation 3.
    threshold: f32,
    // Side of a cell, in metres; zero where `subdivisions` decides.
    cell_m: f32,
    // The most cells along the longest side of what there is.
    subdivisions: f32,
    // Number that every triangle carries.
    part: u32,
    // The most that noise adds to the field, in thresholds.
    noise_amplitude: f32,
    noise_per_m: f32,
    noise_octaves: u32,
    noise_seed: u32,
    // Capacities.
    blocks: u32,
    entries: u32,
    active_blocks: u32,
    vertices: u32,
    triangles: u32,
    // Where in the lists of all triangles its own begin.
    first_vertex: u32,
    first_triangle: u32,
    // Invocations that share the blocks around one particle.
    sharers: u32,
    // How far noise has travelled.
    noise_offset_m: vec3f,
    // Side of a cell for each metre from the eye to what is nearest; zero where that does not matter.
    cell_per_m: f32,
    eye: vec3f,
    // Capacity of the lattice's table.
    regions: u32,
}
