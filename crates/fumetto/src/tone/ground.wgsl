// How far away everything is, smoothed along one axis: the form that strokes bend round, without its smallest
// relief.
//
// A straight line is fitted to what lies around a pixel without a break (weighted least squares). So what slopes
// evenly stays where it is, also close to where it ends.

struct Ground {
    axis: vec2i,
    // In texels of this layer; 0 only takes distances from the depth layer.
    radius: i32,
    // Pixels of the picture to one texel of this layer.
    step: i32,
    // Steps in depth that are smoothed over, in pixels as deep as wide: relief of that size is to vanish.
    far_px: f32,
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

// Sums over a run of texels: of weights, of places and their squares, of distances, and of places times distances.
struct Sums {
    weight: f32,
    place: f32,
    square: f32,
    distance: f32,
    product: f32,
}

// Adds the texels to one side, up to the first that lies elsewhere in depth. Distances are counted from that of the middle.
fn with_side(sums: Sums, at: vec2i, side: i32, middle: f32) -> Sums {
    var all = sums;
    var last = middle;
    let far = middle * ground.far_px / view.focal_px;
    for (var step = 1; step <= ground.radius; step++) {
        let beside = before_at(at + ground.axis * (side * step));
        if beside == 0.0 || abs(beside - last) > far {
            break;
        }
        let weight = 1.0 - f32(step) / f32(ground.radius + 1);
        let place = f32(side * step);
        all.weight += weight;
        all.place += weight * place;
        all.square += weight * place * place;
        all.distance += weight * (beside - middle);
        all.product += weight * place * (beside - middle);
        last = beside;
    }
    return all;
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
    let sums = with_side(with_side(Sums(1.0, 0.0, 0.0, 0.0, 0.0), at, -1, middle), at, 1, middle);
    let spread = sums.weight * sums.square - sums.place * sums.place;
    return middle + (sums.square * sums.distance - sums.place * sums.product) / max(spread, 1e-6);
}
