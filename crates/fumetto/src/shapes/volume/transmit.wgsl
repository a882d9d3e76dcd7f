// How much of each light comes through the object's own matter to the middles of the cells of light: a channel
// for each light that throws shadows.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<uniform> lights: Lights;
@group(0) @binding(2) var linear: sampler;
@group(0) @binding(6) var transmitted: texture_storage_3d<rgba16float, write>;

// Whether no matter is near enough to ask this cell for its light.
fn is_far_from_matter(place: vec3f) -> bool {
    let at = cell_of(place);
    let empty = void_at(at);
    return empty.side > 0.0 && all(at - light_side() >= empty.low) && all(at + light_side() <= empty.low + empty.side);
}

@compute @workgroup_size(4, 4, 4)
fn main(@builtin(global_invocation_id) cell: vec3u) {
    if is_nothing() || any(cell >= light_sides()) {
        return;
    }
    let place = light_place(cell);
    var through = vec4f(1.0);
    let count = select(lights.count, 0u, is_far_from_matter(place));
    for (var i = 0u; i < count; i++) {
        let light = lights.light[i];
        if light.channel >= 0 && recipe.shadows != 0u {
            through[light.channel] = exp(-depth_toward(light, place));
        }
    }
    textureStore(transmitted, cell, through);
}
