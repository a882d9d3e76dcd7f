// Finds the small tiles of the picture in which borders between shapes run: only these are then looked through
// closely.

// Whether borders between triangles of one piece count, too.
override HAS_IMAGE: bool = true;

@group(0) @binding(0) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(1) var<storage, read> parts: array<Part>;
@group(0) @binding(2) var<storage, read> pieces: array<u32>;
@group(0) @binding(3) var id_layer: texture_2d<u32>;

// A number that changes where something else is seen.
fn shown_at(px: vec2u) -> u32 {
    let id = textureLoad(id_layer, px, 0).x;
    if HAS_IMAGE || (id & TRIANGLE_BIT) == 0u {
        return select(select(0u, 1u, id != 0u), id, HAS_IMAGE);
    }
    return piece_of(id & ~TRIANGLE_BIT) + 2u;
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    // One pixel on all sides, for what it borders on.
    let low = max(vec2u(position.xy) * LOOK_TILE, vec2u(1u)) - 1u;
    let high = min((vec2u(position.xy) + 1u) * LOOK_TILE, textureDimensions(id_layer) - 1u);
    var differ = false;
    for (var y = low.y; y <= high.y; y++) {
        var before = shown_at(vec2u(low.x, y));
        for (var x = low.x + 1u; x <= high.x; x++) {
            let own = shown_at(vec2u(x, y));
            differ |= own != before;
            before = own;
        }
    }
    for (var x = low.x; x <= high.x; x++) {
        var above = shown_at(vec2u(x, low.y));
        for (var y = low.y + 1u; y <= high.y; y++) {
            let own = shown_at(vec2u(x, y));
            differ |= own != above;
            above = own;
        }
    }
    return vec4f(f32(differ));
}
