// The share of its width that a line keeps where a surface faces the first light.
fn thinned(style: ObjectStyle, normal: vec3f, place: vec3f) -> f32 {
    if lights.count == 0u {
        return 1.0;
    }
    return 1.0 - style.ink_lit_thinning * max(dot(normal, toward(lights.light[0], place)), 0.0);
}
