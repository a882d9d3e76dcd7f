// Whose matter it is that a ray meets.

@group(0) @binding(9) var owners: texture_3d<u32>;

// Number of the puff that a place belongs to, plus 1.
fn owner_at(at: vec3f, px: vec2f) -> u32 {
    let cell = vec3u(clamp(at, vec3f(0.0), vec3f(grid.cells) - 0.5));
    let owner = textureLoad(owners, cell, 0).x;
    return select(owner, recipe.first + 1u, owner == 0u);
}
