// Draws ink straight into a picture, in those tiles of it that have any.

@group(0) @binding(0) var<uniform> compose: Compose;
@group(0) @binding(1) var<uniform> pens: array<Pen, MAX_PENS>;
@group(0) @binding(2) var ink: texture_2d<u32>;
@group(0) @binding(3) var shares: texture_2d<f32>;
@group(0) @binding(4) var around: texture_2d<f32>;
@group(0) @binding(5) var linear: sampler;

// Pixels along the side of a tile. Also in `compose.rs`.
const TILE: u32 = 32u;

// Two triangles for each tile; those without ink have no size.
@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let size = textureDimensions(ink);
    let columns = (size.x + TILE - 1u) / TILE;
    let tile = vec2u((index / 6u) % columns, (index / 6u) / columns);
    let first = tile * TILE;
    let end = min(first + TILE, size);
    let low = first / u32(compose.cell);
    let high = (end - 1u) / u32(compose.cell);
    var inked = false;
    for (var y = low.y; y <= high.y; y++) {
        for (var x = low.x; x <= high.x; x++) {
            inked |= textureLoad(shares, vec2u(x, y), 0).y > 0.0;
        }
    }
    let corner = array(0u, 1u, 3u, 0u, 3u, 2u)[index % 6u];
    let px = select(first, select(first, end, vec2u(corner & 1u, corner >> 1u) == vec2u(1u)), inked);
    let ndc = vec2f(px) / vec2f(size) * 2.0 - 1.0;
    return vec4f(ndc.x, -ndc.y, 0.0, 1.0);
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let line = line_at(vec2i(position.xy));
    if line.share == 0.0 {
        discard;
    }
    return vec4f(line.colour.rgb, 1.0);
}
