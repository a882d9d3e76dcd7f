const TAU: f32 = 6.2831853;

// Two unit vectors at right angles to `axis` and each other (Duff et al. 2017).
fn across(axis: vec3f) -> mat2x3f {
    let side = select(-1.0, 1.0, axis.z >= 0.0);
    let a = -1.0 / (side + axis.z);
    let b = axis.x * axis.y * a;
    return mat2x3f(
        vec3f(1.0 + side * axis.x * axis.x * a, side * b, -side * axis.x),
        vec3f(b, side + axis.y * axis.y * a, -axis.y),
    );
}
