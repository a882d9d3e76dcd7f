// How a ray goes through the field, which is measured in cells: those of puffs, or voxels of a file.

// A cube without any matter around a place; with side 0 there may be some.
struct Void {
    low: vec3f,
    side: f32,
}

// A ray that never runs along a face to the last bit.
fn askew(ray: vec3f) -> vec3f {
    return select(ray, vec3f(1e-12), abs(ray) < vec3f(1e-12));
}

// Where a ray enters and leaves a box.
fn ends_of(origin: vec3f, ray: vec3f, low: vec3f, high: vec3f) -> vec2f {
    let one = (low - origin) / askew(ray);
    let other = (high - origin) / askew(ray);
    let near = min(one, other);
    let far = max(one, other);
    return vec2f(max(near.x, max(near.y, near.z)), min(far.x, min(far.y, far.z)));
}

// Where a ray leaves an empty cube that it is in.
fn end_of_void(origin: vec3f, ray: vec3f, empty: Void) -> f32 {
    let far = select(empty.low, empty.low + empty.side, ray > vec3f(0.0));
    let away = (far - origin) / askew(ray);
    return min(away.x, min(away.y, away.z));
}
