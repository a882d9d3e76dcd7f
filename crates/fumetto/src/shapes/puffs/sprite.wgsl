// A puff as the camera sees it.
struct Sprite {
    // Middle, in pixels.
    px: vec2f,
    radius_px: f32,
    // Of the middle, in metres along the line of sight; zero when there is nothing to see.
    distance: f32,
}

fn sprite_of(puff: Puff) -> Sprite {
    let position = (view.view_from_world * vec4f(puff.center, 1.0)).xyz;
    let distance = -position.z;
    // A billboard through the camera has no picture.
    if puff.radius <= 0.0 || distance <= view.near {
        return Sprite(vec2f(0.0), 0.0, 0.0);
    }
    return Sprite(px_of(position), puff.radius * view.focal_px / distance, distance);
}
