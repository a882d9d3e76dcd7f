// Width of an object's outline at a distance, in pixels.
fn ink_width_px(style: ObjectStyle, distance: f32) -> f32 {
    return max(style.ink_width_px, style.ink_width_m * view.focal_px / distance);
}
