// The volume that a puff keeps from a light, and where on the screen it may be seen.

struct Volume {
    // In view space.
    middle: vec3f,
    axis: vec3f,
    radius: f32,
    // From where (in the puff's height) to where (in metres) along the axis.
    first: f32,
    last: f32,
    // Middle and half sides of a rectangle around it on the screen.
    px: vec2f,
    along_px: vec2f,
    side_px: vec2f,
    // Distance of its nearest place; the near plane's where it reaches behind the camera.
    nearest: f32,
}

// The direction in which light travels at a place; all in view space.
fn axis_of(place: vec3f, light: Light) -> vec3f {
    let source = (view.view_from_world * vec4f(light.vector, light.is_point)).xyz;
    return normalize(place * light.is_point - source);
}

fn volume_of(puff: Puff, style: ObjectStyle, light: Light) -> Volume {
    let radius = puff.radius * style.shadow_size;
    let middle = (view.view_from_world * vec4f(puff.center, 1.0)).xyz;
    let axis = axis_of(middle, light);
    let last = style.shadow_reach * puff.radius;
    let end = middle + axis * last;
    let nearest = min(-middle.z, -end.z) - radius;
    if nearest <= view.near {
        // Partly behind the camera: it may be anywhere.
        let half = 0.5 * view.size_px;
        return Volume(middle, axis, radius, style.shadow_start, last, half, vec2f(half.x, 0.0), vec2f(0.0, half.y), view.near);
    }
    let from_px = px_of(middle);
    let to_px = px_of(end);
    let radius_px = radius * view.focal_px / nearest;
    let line = to_px - from_px;
    let length_px = length(line);
    let along = select(vec2f(1.0, 0.0), line / length_px, length_px > 0.5);
    return Volume(
        middle, axis, radius, style.shadow_start, last,
        0.5 * (from_px + to_px),
        along * (0.5 * length_px + radius_px),
        vec2f(-along.y, along.x) * radius_px,
        nearest,
    );
}
