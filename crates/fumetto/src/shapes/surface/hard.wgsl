// Vertices that a few steps of Newton's method did not find, by block and number in it.
struct Hard {
    // Workgroups of `careful.wgsl`.
    groups_x: atomic<u32>,
    groups_y: u32,
    groups_z: u32,
    count: atomic<u32>,
    vertices: array<u32>,
}
