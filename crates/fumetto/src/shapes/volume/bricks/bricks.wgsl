// The field of a volume out of a file: its voxels in bricks, of which only those with matter are kept. `cells.wgsl`
// says the same of puffs. Uses `recipe` of the program that it is part of.

fn is_nothing() -> bool {
    return bricks.nodes.x == 0u;
}

fn low_end() -> vec3f {
    return bricks.low;
}

fn high_end() -> vec3f {
    return bricks.high;
}

fn void_at(at: vec3f) -> Void {
    let voxel = vec3u(clamp(at, vec3f(0.0), vec3f(bricks.nodes * (BRICK * NODE)) - 0.5));
    let entry = entry_of(voxel / BRICK);
    return Void(vec3f(entry.low * i32(BRICK)), select(f32(entry.width * BRICK), 0.0, entry.is_kept));
}

fn heat_of(sample: vec4f) -> f32 {
    return select(1.0, sample.g / sample.r, bricks.has_heat != 0u);
}

// From the cold to the hot.
fn colour_of(sample: vec4f) -> vec3f {
    if bricks.has_heat == 0u {
        return recipe.colours[0].rgb;
    }
    let last = recipe.colour_count - 1u;
    let along = clamp(heat_of(sample), 0.0, 1.0) * f32(last);
    let below = min(u32(along), last);
    let above = min(below + 1u, last);
    return mix(recipe.colours[below].rgb, recipe.colours[above].rgb, along - f32(below));
}

fn light_side() -> f32 {
    return bricks.light_side;
}

fn light_sides() -> vec3u {
    return bricks.light_sides;
}

fn light_place(cell: vec3u) -> vec3f {
    let at = bricks.low + (vec3f(cell) + 0.5) * bricks.light_side;
    return (bricks.world_from_voxel * vec4f(at, 1.0)).xyz;
}
