// Averages normals along one axis, over what lies at much the same depth, so that tones get shapes of a
// least size. Their edges stay crisp: they are found in the average.

struct Soften {
    axis: vec2i,
    // In texels of this layer.
    radius: i32,
    // Texels of this layer in a pixel of the picture: 1 / step.
    scale: f32,
    focal_px: f32,
}

@group(0) @binding(0) var<uniform> soften: Soften;
@group(0) @binding(1) var normals: texture_2d<f32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let at = vec2i(position.xy);
    let last = vec2i(textureDimensions(normals)) - 1;
    let middle = textureLoad(normals, at, 0);
    // The layer keeps logarithms of distances: their difference is the relative one, to first order.
    let depth_scale = 0.693147 * soften.focal_px * soften.scale;
    var normal = vec3f(0.0);
    var total = 0.0;
    for (var step = -soften.radius; step <= soften.radius; step++) {
        let place = clamp(at + soften.axis * step, vec2i(0), last);
        let other = textureLoad(normals, place, 0);
        // Depth may differ as on a surface seen at 70 degrees, and by a texel's roughness.
        let depth_px = abs(other.w - middle.w) * depth_scale;
        let near = depth_px < 3.0 * f32(abs(step)) + 2.0 && any(other.xyz != vec3f(0.0));
        let weight = select(0.0, 1.0, near);
        normal += other.xyz * weight;
        total += weight;
    }
    if total == 0.0 || all(middle.xyz == vec3f(0.0)) {
        return vec4f(0.0);
    }
    return vec4f(normal / total, middle.w);
}
