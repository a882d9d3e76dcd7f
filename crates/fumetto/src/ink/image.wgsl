// Finds lines in the picture itself: where neighbouring pixels show different things (Real-Time Rendering,
// section 11.2: image processing; Saito & Takahashi, "Comprehensible Rendering of 3-D Shapes", 1990). What is
// found are seeds, which the flood makes as wide as their pens.
//
// Ours: most pixels are done with as soon as their neighbours show the same triangle or puff. Depth is
// compared with the planes that both pixels lie on, so that a floor seen at a low angle has no lines.

struct Image {
    // Half the width of the widest line.
    radius_px: f32,
    // Number of the first object that has lines.
    first: u32,
}

@group(0) @binding(1) var<uniform> image: Image;
@group(0) @binding(2) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(3) var<uniform> lights: Lights;
@group(0) @binding(4) var<storage, read> puffs: array<Puff>;
@group(0) @binding(5) var<uniform> pens: array<Pen, MAX_PENS>;
@group(0) @binding(6) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(7) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(8) var<storage, read> parts: array<Part>;
@group(0) @binding(9) var<storage, read> pieces: array<u32>;
@group(0) @binding(10) var<storage, read_write> tiles: array<atomic<u32>>;
@group(0) @binding(11) var id_layer: texture_2d<u32>;
@group(0) @binding(12) var depth_layer: texture_depth_2d;
@group(0) @binding(13) var ink_layer: texture_2d<u32>;
@group(0) @binding(14) var borders: texture_2d<f32>;

// Lines that taper end where they are narrower than this, in pixels.
const THINNEST_PX: f32 = 0.7;

fn half_width_px(p: Seen, edge: Border) -> f32 {
    let pen = pens[pen_number(p.object, edge.kind)];
    let full = max(pen.width_px, pen.width_m * view.focal_px / p.distance);
    let kept = thinned(styles[p.object], p.normal, p.place);
    let width = full * edge.share * kept;
    let draws = (pen.flags & DRAWS) != 0u && kept >= FINEST && edge.share > 0.0 && (width >= THINNEST_PX || edge.share == 1.0);
    return min(0.5 * select(0.0, max(width, 1.0), draws), image.radius_px);
}

// Tells the tiles that a line through the middle of a pixel may reach.
fn mark_tiles(px: vec2i, reach: i32, size: vec2i) {
    let columns = (size.x + i32(TILE) - 1) / i32(TILE);
    let low = max(px - reach, vec2i(0)) / i32(TILE);
    let high = min(px + reach, size - 1) / i32(TILE);
    for (var y = low.y; y <= high.y; y++) {
        for (var x = low.x; x <= high.x; x++) {
            atomicStore(&tiles[y * columns + x], 1u);
        }
    }
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let size = textureDimensions(id_layer);
    let drawn = textureLoad(borders, tile_of(index, size, LOOK_TILE), 0).x > 0.0;
    return tile_corner(index, size, LOOK_TILE, drawn);
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec2u {
    let px = vec2i(position.xy);
    let size = vec2i(textureDimensions(id_layer));
    let id = textureLoad(id_layer, px, 0).x;
    let ways = array(vec2i(-1, 0), vec2i(1, 0), vec2i(0, -1), vec2i(0, 1));
    var others = array(id, id, id, id);
    var differ = false;
    for (var way = 0; way < 4; way++) {
        others[way] = textureLoad(id_layer, clamp(px + ways[way], vec2i(0), size - 1), 0).x;
        differ |= others[way] != id;
    }
    if id == 0u || !differ {
        discard;
    }
    let own = seen_at(id, px);
    if own.object < image.first {
        discard;
    }
    var edge = Border(KINDS, 0.0);
    var aside = vec2i(0);
    for (var way = 0; way < 4; way++) {
        if others[way] == id {
            continue;
        }
        let found = border_of(own, seen_at(others[way], px + ways[way]));
        // Silhouettes come before all others, and the wider before the finer.
        let wins = found.share > 0.0 && (found.kind < edge.kind || (found.kind == edge.kind && found.share > edge.share));
        let equals = found.share > 0.0 && all(vec2f(f32(found.kind), found.share) == vec2f(f32(edge.kind), edge.share));
        aside = select(select(aside, aside + ways[way], equals), ways[way], wins);
        edge = Border(select(edge.kind, found.kind, wins), select(edge.share, found.share, wins));
    }
    let half_width = half_width_px(own, edge);
    // Ink of another method is there already.
    let is_image = (own.flags & IMAGE_INK) != 0u;
    if half_width == 0.0 || (!is_image && textureLoad(ink_layer, px, 0).x != 0u) {
        discard;
    }
    mark_tiles(px, i32(ceil(half_width)) + 1, size);
    // A line an odd number of pixels wide has a middle pixel; others run between two.
    let is_odd = (i32(round(2.0 * half_width)) & 1) == 1;
    let mark = vec2u(pen_number(own.object, edge.kind) + 1u, u32(round(255.0 * own.opacity)));
    return seed_of(px, select(aside, vec2i(0), is_odd), half_width, mark);
}
