// Whose matter it is that a ray meets: all is of one object, which the first two of its lobes stand for in turn, so
// that between any two pixels a line is looked for.
fn owner_at(at: vec3f, px: vec2f) -> u32 {
    return recipe.first + 1u + ((u32(px.x) + u32(px.y)) & 1u);
}
