// How much of each light comes through the object's own matter to the middles of the cells of light: a channel
// for each light that throws shadows.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<uniform> lights: Lights;
@group(0) @binding(2) var linear: sampler;
@group(0) @binding(6) var transmitted: texture_storage_3d<rgba16float, write>;

// Optical depth beyond which nothing comes through that a half float tells from nothing.
const OPAQUE: f32 = 17.0;

// Steps are about as long as a cell of light, but no longer than this, in cells.
const LONGEST: f32 = 4.0;

// Optical depth between a place and a light.
fn depth_toward(light: Light, place: vec3f) -> f32 {
    let direction = toward(light, place);
    let origin = cell_of(place);
    let ray = cells_along(direction);
    var away = max(ends_of(origin, ray, low_end(), high_end()).y, 0.0);
    if light.is_point > 0.0 {
        away = min(away, distance(light.vector, place));
    }
    let steps = ceil(away * length(ray) / min(light_side(), LONGEST));
    let step_m = away / max(steps, 1.0);
    let optical_step = step_m * recipe.extinction;
    var sum = 0.0;
    var step = 0.5;
    while step < steps && sum * optical_step < OPAQUE {
        let at = origin + ray * (step * step_m);
        let empty = void_at(at);
        if empty.side > 0.0 {
            step = max(step + 1.0, ceil(end_of_void(origin, ray, empty) / step_m - 0.5) + 0.5);
        } else {
            sum += density_of(sample_at(at));
            step += 1.0;
        }
    }
    return sum * optical_step;
}

@compute @workgroup_size(4, 4, 4)
fn main(@builtin(global_invocation_id) cell: vec3u) {
    if is_nothing() || any(cell >= light_sides()) {
        return;
    }
    let place = light_place(cell);
    var through = vec4f(1.0);
    for (var i = 0u; i < lights.count; i++) {
        let light = lights.light[i];
        if light.channel >= 0 && recipe.shadows != 0u {
            through[light.channel] = exp(-depth_toward(light, place));
        }
    }
    textureStore(transmitted, cell, through);
}
