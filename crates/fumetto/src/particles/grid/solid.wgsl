// What obstacles are in the cells of a grid.

// Velocity in m/s, and how far away their surface is, in cells: below zero inside.
fn solid_at(c: vec3u) -> vec4f {
    let both = solid[cell_index(c)];
    return vec4f(unpack2x16float(both.x), unpack2x16float(both.y));
}
