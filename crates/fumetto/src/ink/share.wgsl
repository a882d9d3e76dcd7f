// The share of each cell of the picture that is inked; then 1 where any of it is.

struct Share {
    // Pixels along the side of a cell.
    cell: u32,
}

@group(0) @binding(0) var<uniform> cells: Share;
@group(0) @binding(1) var ink: texture_2d<u32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let first = vec2u(position.xy) * cells.cell;
    let end = min(first + cells.cell, textureDimensions(ink));
    var inked = 0.0;
    for (var y = first.y; y < end.y; y++) {
        for (var x = first.x; x < end.x; x++) {
            inked += f32(textureLoad(ink, vec2u(x, y), 0).x != 0u);
        }
    }
    return vec4f(inked / f32(cells.cell * cells.cell), min(inked, 1.0), 0.0, 0.0);
}
