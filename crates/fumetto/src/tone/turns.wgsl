// Which way the smoothed form bends most (do Carmo, "Differential Geometry of Curves and Surfaces", section 3-2,
// from the first and second fundamental forms), as a direction on the picture.
//
// A direction and its opposite are the same here, so twice the angle is kept: such vectors can be averaged. They
// are the longer, the more the form bends one way than the other.

struct Turns {
    axis: vec2i,
    // In texels; 0 works directions out, more averages them along the axis.
    radius: i32,
    // Pixels of the picture to one texel of this layer.
    step: i32,
}

@group(0) @binding(1) var<uniform> turns: Turns;
@group(0) @binding(2) var slopes_layer: texture_2d<f32>;
@group(0) @binding(3) var before: texture_2d<f32>;

// Radius of curvature in pixels from which on a form counts as flat.
const FLAT_PX: f32 = 600.0;

// How a place in view space changes from pixel to pixel.
struct Tangents {
    right: vec3f,
    below: vec3f,
}

fn tangents_at(at: vec2i) -> Tangents {
    let slopes = textureLoad(slopes_layer, at, 0);
    let ray = ray_of(vec2f(at * turns.step) + 0.5);
    let pixel = slopes.x / view.focal_px;
    return Tangents(vec3f(pixel, 0.0, 0.0) + ray * slopes.y, vec3f(0.0, -pixel, 0.0) + ray * slopes.z);
}

// How the normal changes along `axis`; `vec3f(0)` where the form ends.
fn bend_along(axis: vec2i, at: vec2i, middle: f32) -> vec3f {
    let last = vec2i(textureDimensions(slopes_layer)) - 1;
    let places = array(max(at - axis, vec2i(0)), min(at + axis, last));
    var normals: array<vec3f, 2>;
    for (var side = 0; side < 2; side++) {
        let distance = textureLoad(slopes_layer, places[side], 0).x;
        if abs(distance / middle - 1.0) > 0.1 {
            return vec3f(0.0);
        }
        let tangents = tangents_at(places[side]);
        normals[side] = normalize(cross(tangents.below, tangents.right));
    }
    return (normals[1] - normals[0]) / f32(2 * turns.step);
}

fn turn_at(at: vec2i) -> vec2f {
    let middle = textureLoad(slopes_layer, at, 0).x;
    if middle == 0.0 {
        return vec2f(0.0);
    }
    let surface = tangents_at(at);
    let bend_x = bend_along(vec2i(1, 0), at, middle);
    let bend_y = bend_along(vec2i(0, 1), at, middle);
    let first = vec3f(dot(surface.right, surface.right), dot(surface.right, surface.below), dot(surface.below, surface.below));
    let mixed = 0.5 * (dot(bend_x, surface.below) + dot(bend_y, surface.right));
    let second = vec3f(dot(bend_x, surface.right), mixed, dot(bend_y, surface.below));
    let area = max(first.x * first.z - first.y * first.y, 1e-30);
    let mean = 0.5 * (first.x * second.z - 2.0 * first.y * second.y + first.z * second.x) / area;
    let apart = sqrt(max(mean * mean - (second.x * second.z - second.y * second.y) / area, 0.0));
    let most = mean + select(-apart, apart, mean >= 0.0);
    let least = 2.0 * mean - most;
    let rows = second - most * first;
    let one = vec2f(-rows.y, rows.x);
    let other = vec2f(rows.z, -rows.y);
    let along = select(one, other, dot(other, other) > dot(one, one));
    let flat = view.focal_px / (middle * FLAT_PX);
    let sure = (abs(most) - abs(least)) / (abs(most) + abs(least) + flat);
    // Up the picture, as angles count.
    return clamp(sure, 0.0, 1.0) * twice(along * vec2f(1.0, -1.0));
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec2f {
    let at = vec2i(position.xy);
    if turns.radius == 0 {
        return turn_at(at);
    }
    let last = vec2i(textureDimensions(before)) - 1;
    var sum = vec2f(0.0);
    for (var step = -turns.radius; step <= turns.radius; step++) {
        sum += textureLoad(before, clamp(at + turns.axis * step, vec2i(0), last), 0).xy;
    }
    return sum / f32(2 * turns.radius + 1);
}
