// How far away the smoothed form is, and how that changes across the picture.

struct Slopes {
    // Pixels of the picture to one texel of this layer.
    step: f32,
    far_px: f32,
}

@group(0) @binding(1) var<uniform> slopes: Slopes;
@group(0) @binding(2) var ground: texture_2d<f32>;

// How much farther the form is at the next texel along `axis`; 0 where it ends on both sides.
fn slope_along(axis: vec2i, at: vec2i, middle: f32) -> f32 {
    let size = vec2i(textureDimensions(ground));
    let far = middle * slopes.far_px / view.focal_px;
    var sum = 0.0;
    var sides = 0.0;
    for (var side = -1; side <= 1; side += 2) {
        let place = at + axis * side;
        let inside = all(place >= vec2i(0)) && all(place < size);
        let beside = textureLoad(ground, clamp(place, vec2i(0), size - 1), 0).x;
        if inside && beside > 0.0 && abs(beside - middle) < far {
            sum += (beside - middle) * f32(side);
            sides += 1.0;
        }
    }
    return sum / max(sides, 1.0);
}

// Metres before the camera, and metres for a pixel to the right and below.
@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let at = vec2i(position.xy);
    let middle = textureLoad(ground, at, 0).x;
    let slope = vec2f(slope_along(vec2i(1, 0), at, middle), slope_along(vec2i(0, 1), at, middle));
    return vec4f(middle, slope / slopes.step, 0.0);
}
