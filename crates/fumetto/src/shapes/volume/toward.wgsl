// How much matter lies between a place and a light. Uses `recipe` of the program that it is part of.

// Optical depth beyond which nothing comes through that a half float tells from nothing.
const OPAQUE: f32 = 17.0;

// Steps are about as long as a cell of light, but no longer than this, in cells.
const LONGEST: f32 = 4.0;

// Optical depth between a place and a light.
fn depth_toward(light: Light, place: vec3f) -> f32 {
    let direction = toward(light, place);
    let origin = cell_of(place);
    let ray = cells_along(direction);
    let ends = ends_of(origin, ray, low_end(), high_end());
    let begin = max(ends.x, 0.0);
    var away = max(ends.y, begin);
    if light.is_point > 0.0 {
        away = max(min(away, distance(light.vector, place)), begin);
    }
    let steps = ceil((away - begin) * length(ray) / min(light_side(), LONGEST));
    let step_m = (away - begin) / max(steps, 1.0);
    let optical_step = step_m * recipe.extinction;
    var sum = 0.0;
    var step = 0.5;
    while step < steps && sum * optical_step < OPAQUE {
        let at = origin + ray * (begin + step * step_m);
        let empty = void_at(at);
        if empty.side > 0.0 {
            step = max(step + 1.0, ceil((end_of_void(origin, ray, empty) - begin) / step_m - 0.5) + 0.5);
        } else {
            sum += density_of(sample_at(at));
            step += 1.0;
        }
    }
    return sum * optical_step;
}
