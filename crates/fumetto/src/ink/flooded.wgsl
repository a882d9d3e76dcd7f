// Inks what is within half a line's width of a seed.

@group(0) @binding(1) var<storage, read> tiles: array<u32>;
@group(0) @binding(2) var<storage, read> puffs: array<Puff>;
@group(0) @binding(3) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(4) var<storage, read> parts: array<Part>;
@group(0) @binding(5) var seeds: texture_2d<u32>;
@group(0) @binding(6) var id_layer: texture_2d<u32>;
@group(0) @binding(7) var depth_layer: texture_depth_2d;

// How much nearer than the line a surface may come toward it, in metres to a metre beside it: 76 degrees.
const SLOPE: f32 = 4.0;

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return tile_corner(index, textureDimensions(seeds), TILE, tiles[index / 6u] != 0u);
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec2u {
    let px = vec2i(position.xy);
    let seed = textureLoad(seeds, px, 0).xy;
    if outside_px(seed, position.xy) >= 0.0 {
        discard;
    }
    let mark = vec2u((seed.y >> 16u) & 0xffu, seed.y >> 24u);
    let id = textureLoad(id_layer, px, 0).x;
    if id == 0u || object_of(id) != (mark.x - 1u) / KINDS {
        // A line lies on what it belongs to: whatever stands before that hides it.
        let away = distance_of(textureLoad(depth_layer, vec2i(seed_px(seed)), 0));
        let nearest = away * (1.0 - SLOPE * seed_half_width_px(seed) / view.focal_px);
        if textureLoad(depth_layer, px, 0) > depth_of(nearest) {
            discard;
        }
    }
    return mark;
}
