// Brings to each pixel what was found along the lines of sight through the middles of squares of pixels. What is soft is
// blended between the four next to it, as far as what is solid lies as far away there as here; a surface is that of the
// pixel's own square.

@group(0) @binding(1) var<uniform> recipe: Recipe;
@group(0) @binding(2) var depth_layer: texture_depth_2d;
@group(0) @binding(3) var hits: texture_2d<u32>;
@group(0) @binding(4) var light: texture_2d<f32>;
@group(0) @binding(5) var soft: texture_2d<f32>;

// Difference of distances, as a share of them, at which a line of sight counts for half.
const ALIKE: f32 = 0.02;

// How much a line of sight that ends at one depth tells of one that ends at another.
fn likeness(one: f32, other: f32) -> f32 {
    let apart = abs(one - other) / max(max(one, other), 1e-30);
    return ALIKE / (ALIKE + apart);
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> Marched {
    let own = solid_depth(position.xy);
    let square = square_of(position.xy);
    let low = floor(square - 0.5);
    let part = square - 0.5 - low;
    var sum = vec4f(0.0);
    var weights = 0.0;
    for (var i = 0u; i < 4u; i++) {
        let step = vec2f(f32(i & 1u), f32(i >> 1u));
        let share = mix(1.0 - part, part, step);
        let near = likeness(own, solid_depth(px_of_square(low + step + 0.5)));
        sum += share.x * share.y * near * textureLoad(soft, vec2i(low + step), 0);
        weights += share.x * share.y * near;
    }
    let hit = textureLoad(hits, vec2i(square), 0);
    if hit.x == 0u && sum.a == 0.0 {
        discard;
    }
    return Marched(hit, textureLoad(light, vec2i(square), 0), sum / weights);
}
