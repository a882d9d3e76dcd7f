// The eight values around a place in a list: where the first is, and how far it is from there to the others.
struct Around {
    first: u32,
    share: vec3f,
}

// In the list of faces, or of cells, whose last one along each axis is `last`. `p` counts from the first.
fn around(p: vec3f, last: vec3u, stride: vec3u) -> Around {
    let inside = clamp(p, vec3f(0.0), vec3f(last));
    let low = min(vec3u(vec3i(inside)), last - 1u);
    return Around(dot(low, stride), inside - vec3f(low));
}

// Trilinear: of four values at the lower place along z and four at the upper, x first.
fn blend(low: vec4f, high: vec4f, share: vec3f) -> f32 {
    let layer = mix(low, high, share.z);
    let row = mix(layer.xy, layer.zw, share.y);
    return mix(row.x, row.y, share.x);
}
