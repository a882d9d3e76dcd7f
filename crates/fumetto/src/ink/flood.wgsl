// One pass of jump flooding (Rong & Tan, "Jump Flooding in GPU with Applications to Voronoi Diagram and
// Distance Transform", 2006): of its neighbours at one distance, and its own, each pixel takes the seed whose
// line reaches nearest to it. Lines of any width come at the cost of a few passes.

@group(0) @binding(0) var<uniform> jump: i32;
@group(0) @binding(1) var<storage, read> tiles: array<u32>;
@group(0) @binding(2) var seeds: texture_2d<u32>;

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return tile_corner(index, textureDimensions(seeds), TILE, tiles[index / 6u] != 0u);
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec2u {
    let last = vec2i(textureDimensions(seeds)) - 1;
    var best = Seed(0u);
    var least = 1e9;
    for (var y = -1; y <= 1; y++) {
        for (var x = -1; x <= 1; x++) {
            let at = clamp(vec2i(position.xy) + jump * vec2i(x, y), vec2i(0), last);
            let seed = textureLoad(seeds, at, 0).xy;
            let outside = outside_px(seed, position.xy);
            if outside < least {
                best = seed;
                least = outside;
            }
        }
    }
    return best;
}
