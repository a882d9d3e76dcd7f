// How much of each light comes through the object's own matter to the middles of the cells of light: a channel
// for each light that throws shadows.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<uniform> lights: Lights;
@group(0) @binding(2) var<storage, read> grid: VolumeGrid;
@group(0) @binding(3) var density: texture_3d<f32>;
@group(0) @binding(4) var linear: sampler;
@group(0) @binding(5) var transmitted: texture_storage_3d<rgba16float, write>;

// Optical depth beyond which nothing comes through that a half float tells from nothing.
const OPAQUE: f32 = 17.0;

// Distance from a place, along a direction, to where the grid ends.
fn to_end(place: vec3f, direction: vec3f) -> f32 {
    let size = vec3f(grid.cells) * grid.cell_m;
    let far = select(grid.origin, grid.origin + size, direction > vec3f(0.0));
    let safe = select(direction, vec3f(1e-12), abs(direction) < vec3f(1e-12));
    let away = (far - place) / safe;
    return max(min(away.x, min(away.y, away.z)), 0.0);
}

// Optical depth between a place and a light, in steps of about a cell of light.
fn depth_toward(light: Light, place: vec3f) -> f32 {
    let direction = toward(light, place);
    var away = to_end(place, direction);
    if light.is_point > 0.0 {
        away = min(away, distance(light.vector, place));
    }
    let steps = ceil(away / grid.light_cell_m);
    let step_m = away / max(steps, 1.0);
    var sum = 0.0;
    for (var step = 0.5; step < steps && sum * step_m * recipe.extinction < OPAQUE; step += 1.0) {
        let at = (place + direction * (step * step_m) - grid.origin) / (grid.cell_m * vec3f(grid.cells));
        sum += textureSampleLevel(density, linear, at, 0.0).a;
    }
    return sum * step_m * recipe.extinction;
}

@compute @workgroup_size(4, 4, 4)
fn main(@builtin(global_invocation_id) cell: vec3u) {
    if any(cell >= grid.light_cells) {
        return;
    }
    let place = grid.origin + (vec3f(cell) + 0.5) * grid.light_cell_m;
    var through = vec4f(1.0);
    for (var i = 0u; i < lights.count; i++) {
        let light = lights.light[i];
        if light.channel >= 0 && recipe.shadows != 0u {
            through[light.channel] = exp(-depth_toward(light, place));
        }
    }
    textureStore(transmitted, cell, through);
}
