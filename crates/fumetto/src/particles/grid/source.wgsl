// Where an emitter brings heat, smoke and motion into the air.
struct Source {
    center: vec3f,
    radius: f32,
    // Unit normal and share of the radius that is a hole, sides, or the line from `center`.
    extent: vec4f,
    velocity: vec3f,
    // 0 point, 1 disc, 2 sphere, 3 box, 4 line.
    shape: u32,
    // What the air in it has: 1 is as hot as what `buoyancy` lifts at birth, and as thick as smoke at birth.
    heat: f32,
    smoke: f32,
    // Air that appears in it: its own volume so often a second.
    expansion: f32,
    // 1: it takes the air along at its velocity.
    drives: u32,
}

// Distance from a shape; none inside.
fn distance_from(source: Source, p: vec3f) -> f32 {
    let offset = p - source.center;
    switch source.shape {
        case 1u: {
            let along = dot(offset, source.extent.xyz);
            let out = length(offset - along * source.extent.xyz);
            let rim = max(out - source.radius, source.extent.w * source.radius - out);
            return length(vec2f(along, max(rim, 0.0)));
        }
        case 2u: { return max(length(offset) - source.radius, 0.0); }
        case 3u: { return length(max(abs(offset) - 0.5 * source.extent.xyz, vec3f(0.0))); }
        case 4u: {
            let line = source.extent.xyz;
            let share = clamp(dot(offset, line) / max(dot(line, line), 1e-12), 0.0, 1.0);
            return length(offset - share * line);
        }
        default: { return length(offset); }
    }
}

// How much of a cell is in it: all where its middle is inside, none from a side away on, so that even what is
// thinner than a cell is felt.
fn share_of(source: Source, p: vec3f) -> f32 {
    return clamp(1.0 - distance_from(source, p) / grid.side, 0.0, 1.0);
}
