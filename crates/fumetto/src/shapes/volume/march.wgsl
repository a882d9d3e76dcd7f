// Follows lines of sight through the field, up to what is solid (Normoyle, "Volumetric Clouds"): per step the transmittance falls by exp(-extinction * step * density), and what the step takes away of it is
// its share of the picture.
//
// The paper takes the transmittance after the step, and divides by the extinction; taken before it, the sum of
// a homogeneous stretch is exact whatever the step, and a thick cloud has the colour that was picked for it.

@group(0) @binding(1) var<uniform> recipe: Recipe;
@group(0) @binding(2) var linear: sampler;
@group(0) @binding(6) var<uniform> lights: Lights;
@group(0) @binding(7) var transmitted: texture_3d<f32>;
@group(0) @binding(8) var depth_layer: texture_depth_2d;

// Transmittance under which the rest is not looked at: less than half of an 8-bit step.
const SPENT: f32 = 0.001;

// Steps to a cell, at most: finer ones show nothing more.
const FINEST: f32 = 16.0;

// Steps along a line of sight, at most: single floats count as many. Default steps through the widest box are fewer.
const MOST_STEPS: f32 = 4194304.0;

// The part of a line of sight that lies in the field, in metres before the camera.
struct Sight {
    // In cells.
    eye: vec3f,
    ray: vec3f,
    begin: f32,
    end: f32,
    // In the world.
    way: vec3f,
}

fn sight_of(px: vec2f) -> Sight {
    let way = world_ray(px);
    let eye = cell_of(view.world_from_view[3].xyz);
    let ray = cells_along(way);
    let ends = ends_of(eye, ray, low_end(), high_end());
    let depth = solid_depth(px);
    let solid = select(3e38, distance_of(depth), depth > 0.0);
    return Sight(eye, ray, max(ends.x, view.near), min(ends.y, solid), way);
}

// The part of a step at which it is sampled. The pattern stays where it is on the picture, so that a paused one
// is still (Jimenez, "Next Generation Post Processing in Call of Duty", 2014). A drawn surface wants none.
fn sampled_at(px: vec2f) -> f32 {
    // Neighbouring tiles of a picture share one pattern.
    let square = floor((px + view.first_px) / recipe.pixels);
    let noise = fract(52.9829189 * fract(dot(square, vec2f(0.06711056, 0.00583715))));
    return select(0.5, noise, recipe.soft > 0.0);
}

// A step in which there is matter, or the first beyond the grid.
struct Step {
    number: f32,
    // In metres before the camera, and its length.
    start: f32,
    part: f32,
    // Where it is sampled, and what is there.
    at: vec3f,
    sample: vec4f,
}

fn step_at(sight: Sight, number: f32, step: f32, offset: f32) -> Step {
    let start = sight.begin + number * step;
    let part = min(step, sight.end - start);
    return Step(number, start, part, sight.eye + sight.ray * (start + offset * part), vec4f(0.0));
}

// The next step from `number` on that is in no void.
fn next_occupied(sight: Sight, number: f32, step: f32, offset: f32) -> Step {
    var next = step_at(sight, number, step, offset);
    while next.start < sight.end {
        let empty = void_at(next.at);
        if empty.side == 0.0 {
            break;
        }
        let leap = ceil((end_of_void(sight.eye, sight.ray, empty) - sight.begin) / step - offset);
        next = step_at(sight, max(next.number + 1.0, leap), step, offset);
    }
    return next;
}

// The next one that has some itself. Loops in each other, for a processor that draws in place of a graphics card
// works out both sides of a branch: so it does not look for light where there is no matter.
fn next_matter(sight: Sight, number: f32, step: f32, offset: f32) -> Step {
    var next = next_occupied(sight, number, step, offset);
    while next.start < sight.end {
        next.sample = sample_at(next.at);
        if density_of(next.sample) > 0.0 {
            break;
        }
        next = next_occupied(sight, next.number + 1.0, step, offset);
    }
    return next;
}

// Lights that throw no shadow light all alike.
fn light_everywhere() -> f32 {
    var sum = 0.0;
    for (var i = 0u; i < lights.count; i++) {
        sum += select(0.0, lights.light[i].intensity, lights.light[i].channel < 0);
    }
    return sum;
}

fn light_of_channels() -> vec4f {
    var sum = vec4f(0.0);
    for (var i = 0u; i < lights.count; i++) {
        if lights.light[i].channel >= 0 {
            sum[lights.light[i].channel] = lights.light[i].intensity;
        }
    }
    return sum;
}

// Which way the matter thins out.
fn normal_at(at: vec3f, toward_eye: vec3f) -> vec3f {
    let step = vec2f(1.0, 0.0);
    let falls = vec3f(
        density_of(sample_at(at - step.xyy)) - density_of(sample_at(at + step.xyy)),
        density_of(sample_at(at - step.yxy)) - density_of(sample_at(at + step.yxy)),
        density_of(sample_at(at - step.yyx)) - density_of(sample_at(at + step.yyx)),
    );
    let slope = slope_in_world(falls);
    let steep = length(slope);
    return select(toward_eye, slope / max(steep, 1e-12), steep > 1e-9);
}

// What was gathered on the way to the surface.
struct Met {
    is_surface: bool,
    // In metres before the camera.
    distance: f32,
    colour: vec3f,
    // Share of the matter's own light.
    heat: f32,
}

fn surface_of(sight: Sight, px: vec2f, met: Met) -> vec4u {
    if !met.is_surface {
        return vec4u(0u);
    }
    let at = sight.eye + sight.ray * met.distance;
    let normal = normal_at(at, -normalize(sight.way));
    return vec4u(
        owner_at(at, px),
        bitcast<u32>(depth_of(met.distance)),
        octahedral_packed(normal),
        pack4x8unorm(vec4f(met.colour, met.heat)),
    );
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> Marched {
    // Nothing is discarded before the end: with a discard ahead of loops, llvmpipe (LLVM 15) loses the pixels of which
    // a triangle covers only some.
    let px = px_of_square(position.xy);
    let sight = sight_of(px);
    // Metres and cells along the line of sight to a metre before the camera.
    let stretch = length(sight.way);
    let cells = length(sight.ray);
    let wanted = select(recipe.step_m / stretch, recipe.step_cells / cells, recipe.step_m == 0.0);
    let step = max(max(wanted, 1.0 / (FINEST * cells)), (sight.end - sight.begin) / MOST_STEPS);
    let offset = sampled_at(px);
    let everywhere = light_everywhere();
    let channels = light_of_channels();
    let light_size = light_side() * vec3f(light_sides());

    var left = 1.0;
    var seen = vec3f(0.0);
    var matter = vec4f(0.0);
    var lit = vec4f(0.0);
    var met: Met;
    var marched: Marched;
    var number = 0.0;
    while left > SPENT && !is_nothing() {
        let next = next_matter(sight, number, step, offset);
        if !(next.start < sight.end) {
            break;
        }
        number = next.number + 1.0;
        let optical = recipe.extinction * density_of(next.sample) * next.part * stretch;
        let share = left * (1.0 - exp(-optical));
        let light = textureSampleLevel(transmitted, linear, (next.at - low_end()) / light_size, 0.0);
        let colour = colour_of(next.sample);
        let heat = heat_of(next.sample);
        seen += share * colour * (recipe.glow * heat + everywhere + dot(channels, light));
        matter += share * vec4f(colour, heat);
        lit += share * light;
        let after = left - share;
        if !met.is_surface && after <= 1.0 - recipe.surface {
            let into = log(left / (1.0 - recipe.surface)) / optical;
            let mean = matter / (1.0 - after);
            met = Met(true, next.start + clamp(into, 0.0, 1.0) * next.part, mean.rgb, mean.a);
            marched.light = lit / (1.0 - after);
            if recipe.soft == 0.0 {
                break;
            }
        }
        left = after;
    }
    if !met.is_surface && (recipe.soft == 0.0 || left == 1.0) {
        discard;
    }
    // Not in the loop, where a processor that draws would look for the normal in every step.
    marched.hit = surface_of(sight, px, met);
    let opacity = select(1.0 - left, 1.0, left <= SPENT);
    marched.soft = vec4f(seen, opacity);
    return marched;
}
