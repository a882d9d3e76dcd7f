// How far away everything is, smoothed along one axis: the form that strokes bend round, without its smallest
// relief.
//
// Places on both sides of a pixel count in pairs, or not at all. So what slopes evenly stays where it is, also
// close to where it ends.

struct Ground {
    axis: vec2i,
    // In texels of this layer; 0 only takes distances from the depth layer.
    radius: i32,
    // Pixels of the picture to one texel of this layer.
    step: i32,
}

@group(0) @binding(1) var<uniform> ground: Ground;
@group(0) @binding(2) var depth_layer: texture_depth_2d;
@group(0) @binding(3) var before: texture_2d<f32>;

// Metres before the camera, 0 where there is nothing.
fn before_at(at: vec2i) -> f32 {
    let size = vec2i(textureDimensions(before));
    if any(at < vec2i(0)) || any(at >= size) {
        return 0.0;
    }
    return textureLoad(before, at, 0).x;
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) f32 {
    let at = vec2i(position.xy);
    if ground.radius == 0 {
        let depth = textureLoad(depth_layer, at * ground.step, 0);
        return select(0.0, distance_of(max(depth, 1e-30)), depth > 0.0);
    }
    let middle = before_at(at);
    if middle == 0.0 {
        return 0.0;
    }
    var sum = middle;
    var total = 1.0;
    for (var step = 1; step <= ground.radius; step++) {
        let one = before_at(at - ground.axis * step);
        let other = before_at(at + ground.axis * step);
        // As on a surface seen at 75 degrees, and by a texel's roughness.
        let far = middle * (4.0 * f32(step) + 2.0) * f32(ground.step) / view.focal_px;
        if one == 0.0 || other == 0.0 || abs(one - middle) > far || abs(other - middle) > far {
            break;
        }
        let weight = 1.0 - f32(step) / f32(ground.radius + 1);
        sum += weight * (one + other);
        total += 2.0 * weight;
    }
    return sum / total;
}
