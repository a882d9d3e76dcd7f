// Follows each pixel's line of sight through the field, up to what is solid (Normoyle, "Volumetric Clouds"):
// per step the transmittance falls by exp(-extinction * step * density), and what the step takes away of it is
// its share of the picture.
//
// The paper takes the transmittance after the step, and divides by the extinction; taken before it, the sum of
// a homogeneous stretch is exact whatever the step, and a thick cloud has the colour that was picked for it.

@group(0) @binding(1) var<uniform> recipe: Recipe;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var<storage, read> grid: VolumeGrid;
@group(0) @binding(4) var<storage, read> occupied: array<u32>;
@group(0) @binding(5) var density: texture_3d<f32>;
@group(0) @binding(6) var transmitted: texture_3d<f32>;
@group(0) @binding(7) var owners: texture_3d<u32>;
@group(0) @binding(8) var depth_layer: texture_depth_2d;
@group(0) @binding(9) var linear: sampler;

// Transmittance under which the rest is not looked at: less than half of an 8-bit step.
const SPENT: f32 = 0.001;

// Steps to a cell, at most: finer ones show nothing more.
const FINEST: f32 = 16.0;

struct Marched {
    // Of the surface: puff + 1, bits of the depth, normal, and colour. 0 where there is none.
    @location(0) hit: vec4u,
    // How much of each light that throws shadows reaches what is seen of the surface.
    @location(1) light: vec4f,
    // What a camera would see: linear, times its opacity.
    @location(2) soft: vec4f,
}

// The part of a line of sight that lies in the grid, in metres before the camera.
struct Sight {
    // In cells of the grid.
    eye: vec3f,
    ray: vec3f,
    begin: f32,
    end: f32,
}

fn sight_of(px: vec2f) -> Sight {
    let ray = world_ray(px) / grid.cell_m;
    let eye = (view.world_from_view[3].xyz - grid.origin) / grid.cell_m;
    let safe = select(ray, vec3f(1e-12), abs(ray) < vec3f(1e-12));
    let one = -eye / safe;
    let other = (vec3f(grid.cells) - eye) / safe;
    let low = min(one, other);
    let high = max(one, other);
    let depth = textureLoad(depth_layer, vec2i(px), 0);
    let solid = select(3e38, distance_of(depth), depth > 0.0);
    let begin = max(max(low.x, max(low.y, low.z)), view.near);
    return Sight(eye, ray, begin, min(min(high.x, min(high.y, high.z)), solid));
}

// The part of a step at which it is sampled. The pattern stays where it is on the picture, so that a paused one
// is still (Jimenez, "Next Generation Post Processing in Call of Duty", 2014). A drawn surface wants none.
fn sampled_at(px: vec2f) -> f32 {
    let noise = fract(52.9829189 * fract(dot(floor(px), vec2f(0.06711056, 0.00583715))));
    return select(0.5, noise, recipe.soft > 0.0);
}

// Distance at which a line of sight leaves the block of cells that `at` is in.
fn end_of_block(sight: Sight, at: vec3f) -> f32 {
    let low = floor(at / f32(BLOCK)) * f32(BLOCK);
    let far = select(low, low + f32(BLOCK), sight.ray > vec3f(0.0));
    let safe = select(sight.ray, vec3f(1e-12), abs(sight.ray) < vec3f(1e-12));
    let away = (far - sight.eye) / safe;
    return min(away.x, min(away.y, away.z));
}

fn is_occupied(at: vec3f) -> bool {
    let block = vec3u(clamp(at, vec3f(0.0), vec3f(grid.cells) - 0.5)) / BLOCK;
    return occupied[block_number(block, grid.cells)] != 0u;
}

fn density_at(at: vec3f) -> vec4f {
    return textureSampleLevel(density, linear, at / vec3f(grid.cells), 0.0);
}

// A step in which there is matter, or the first beyond the grid.
struct Step {
    number: f32,
    // In metres before the camera, and its length.
    start: f32,
    part: f32,
    // Where it is sampled, and what is there: colour times density, and density.
    at: vec3f,
    matter: vec4f,
}

fn step_at(sight: Sight, number: f32, step: f32, offset: f32) -> Step {
    let start = sight.begin + number * step;
    let part = min(step, sight.end - start);
    return Step(number, start, part, sight.eye + sight.ray * (start + offset * part), vec4f(0.0));
}

// The next step from `number` on in a block that has any matter.
fn next_occupied(sight: Sight, number: f32, step: f32, offset: f32) -> Step {
    var next = step_at(sight, number, step, offset);
    while next.start < sight.end && !is_occupied(next.at) {
        let leap = ceil((end_of_block(sight, next.at) - sight.begin) / step - offset);
        next = step_at(sight, max(next.number + 1.0, leap), step, offset);
    }
    return next;
}

// The next one that has some itself. Loops in each other, for a processor that draws in place of a graphics card
// works out both sides of a branch: so it does not look for light where there is no matter.
fn next_matter(sight: Sight, number: f32, step: f32, offset: f32) -> Step {
    var next = next_occupied(sight, number, step, offset);
    while next.start < sight.end {
        next.matter = density_at(next.at);
        if next.matter.a > 0.0 {
            break;
        }
        next = next_occupied(sight, next.number + 1.0, step, offset);
    }
    return next;
}

// Lights that throw no shadow light all alike, as matter's own does.
fn light_everywhere() -> f32 {
    var sum = recipe.glow;
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
    let slope = vec3f(
        density_at(at - step.xyy).a - density_at(at + step.xyy).a,
        density_at(at - step.yxy).a - density_at(at + step.yxy).a,
        density_at(at - step.yyx).a - density_at(at + step.yyx).a,
    );
    let steep = length(slope);
    return select(toward_eye, slope / max(steep, 1e-12), steep > 1e-6);
}

// Number of the puff that a place belongs to, plus 1.
fn owner_at(at: vec3f) -> u32 {
    let cell = vec3u(clamp(at, vec3f(0.0), vec3f(grid.cells) - 0.5));
    let owner = textureLoad(owners, cell, 0).x;
    return select(owner, recipe.first + 1u, owner == 0u);
}

fn surface_of(sight: Sight, distance: f32, colour: vec3f) -> vec4u {
    let at = sight.eye + sight.ray * distance;
    let normal = normal_at(at, -normalize(sight.ray));
    return vec4u(
        owner_at(at),
        bitcast<u32>(depth_of(distance)),
        octahedral_packed(normal),
        pack4x8unorm(vec4f(colour, 1.0)),
    );
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> Marched {
    if grid.cells.x == 0u {
        discard;
    }
    let sight = sight_of(position.xy);
    if sight.begin >= sight.end {
        discard;
    }
    // Metres along the line of sight to a metre before the camera.
    let stretch = length(sight.ray) * grid.cell_m;
    let wanted_m = select(recipe.step_m, 0.5 * grid.cell_m, recipe.step_m == 0.0);
    let step = max(wanted_m, grid.cell_m / FINEST) / stretch;
    // Neighbouring tiles of a picture share one pattern.
    let offset = sampled_at(position.xy + view.first_px);
    let everywhere = light_everywhere();
    let channels = light_of_channels();
    let light_size = grid.light_cell_m / grid.cell_m * vec3f(grid.light_cells);

    var left = 1.0;
    var seen = vec3f(0.0);
    var matter = vec3f(0.0);
    var lit = vec4f(0.0);
    var marched: Marched;
    var number = 0.0;
    while left > SPENT {
        let next = next_matter(sight, number, step, offset);
        if next.start >= sight.end {
            break;
        }
        number = next.number + 1.0;
        let optical = recipe.extinction * next.matter.a * next.part * stretch;
        let share = left * (1.0 - exp(-optical));
        let light = textureSampleLevel(transmitted, linear, next.at / light_size, 0.0);
        let colour = next.matter.rgb / next.matter.a;
        seen += share * colour * (everywhere + dot(channels, light));
        matter += share * colour;
        lit += share * light;
        let after = left - share;
        if marched.hit.x == 0u && after <= 1.0 - recipe.surface {
            let into = log(left / (1.0 - recipe.surface)) / optical;
            marched.hit = surface_of(sight, next.start + clamp(into, 0.0, 1.0) * next.part, matter / (1.0 - after));
            marched.light = lit / (1.0 - after);
            if recipe.soft == 0.0 {
                break;
            }
        }
        left = after;
    }
    if recipe.soft == 0.0 && marched.hit.x == 0u {
        discard;
    }
    let opacity = select(1.0 - left, 1.0, left <= SPENT);
    marched.soft = vec4f(seen, opacity);
    return marched;
}
