// Adds the shadows that a volume throws on other things: where the matter on the way to a light is opaque enough.

@group(0) @binding(1) var<uniform> recipe: Recipe;
@group(0) @binding(2) var linear: sampler;
@group(0) @binding(6) var<uniform> lights: Lights;
@group(0) @binding(7) var depth_layer: texture_depth_2d;
@group(0) @binding(8) var id_layer: texture_2d<u32>;
@group(0) @binding(9) var known: texture_2d<f32>;

// How steeply the shadow layer goes through one half, where the shadow's edge is, for each unit of opacity. So the edge
// can be found between texels.
const STEEP: f32 = 8.0;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let px = vec2i(position.xy);
    let at = position.xy / vec2f(textureDimensions(depth_layer));
    var shadow = textureSampleLevel(known, linear, at, 0.0);
    let depth = textureLoad(depth_layer, px, 0);
    // Its own surface has its light from the grid.
    let is_own = textureLoad(id_layer, px, 0).x - 1u - recipe.first < recipe.count;
    if depth == 0.0 || is_own || is_nothing() {
        return shadow;
    }
    let place = view.world_from_view[3].xyz + world_ray(position.xy) * distance_of(depth);
    for (var i = 0u; i < lights.count; i++) {
        let light = lights.light[i];
        // Those of clusters come one by one.
        if light.channel >= 0 && light.members == 0.0 {
            let opacity = 1.0 - exp(-depth_toward(light, place));
            let kept = clamp(0.5 + STEEP * (opacity - recipe.murk), 0.0, 1.0);
            shadow[light.channel] = max(shadow[light.channel], kept);
        }
    }
    return shadow;
}
