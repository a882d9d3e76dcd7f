// Marks the pixels whose stencil is not zero.

@fragment
fn fragment() -> @location(0) vec4f {
    return vec4f(1.0);
}
