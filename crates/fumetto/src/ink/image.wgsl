// Finds lines in the picture itself: where neighbouring pixels show different things (Real-Time Rendering,
// section 11.2: image processing; Saito & Takahashi, "Comprehensible Rendering of 3-D Shapes", 1990). What is
// found are seeds, which the flood makes as wide as their pens.
//
// Ours: most pixels are done with as soon as their neighbours show the same triangle or puff. Depth is
// compared with the planes that both pixels lie on, so that a floor seen at a low angle has no lines.

struct Image {
    // Half the width of the widest line.
    radius_px: f32,
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

// Distance from a plane, in pixels, beyond which a neighbour lies on something else.
const STEP_PX: f32 = 1.5;

// Distance from a puff, in its radii, within which shapes run into each other.
const TOUCH: f32 = 0.5;

// Cosine of the angle, 15 degrees, under which pieces that run into each other look like one.
const TURN: f32 = 0.966;

// Lines that taper end where they are narrower than this, in pixels.
const THINNEST_PX: f32 = 0.7;

// What a pixel shows.
struct Seen {
    id: u32,
    object: u32,
    piece: u32,
    material: u32,
    place: vec3f,
    // Along the line of sight.
    distance: f32,
    // Of a triangle's plane, or away from a puff's middle.
    normal: vec3f,
    // Of a puff; 0 for a triangle.
    radius: f32,
    opacity: f32,
}

// A line along the border to a neighbour: none where its share of the pen's width is 0.
struct Edge {
    kind: u32,
    share: f32,
}

fn seen_at(id: u32, px: vec2i) -> Seen {
    let depth = textureLoad(depth_layer, px, 0);
    let distance = select(1e30, distance_of(depth), depth > 0.0);
    if id == 0u {
        return Seen(0u, 0u, 0u, 0u, vec3f(0.0), distance, vec3f(0.0), 0.0, 0.0);
    }
    let ray = world_ray(vec2f(px) + 0.5);
    let place = view.world_from_view[3].xyz + ray * distance;
    if (id & TRIANGLE_BIT) == 0u {
        let puff = puffs[id - 1u];
        let outward = normalize(place - puff.center);
        return Seen(id, puff_object(puff), 0u, 0u, place, distance, outward, puff.radius, puff_fade(puff).y);
    }
    let number = id & ~TRIANGLE_BIT;
    let triangle = triangles[number];
    let part = parts[triangle.part];
    let a = vertices[triangle.corners.x].position;
    let across = cross(vertices[triangle.corners.y].position - a, vertices[triangle.corners.z].position - a);
    let normal = across * (-sign(dot(across, ray)) * inverseSqrt(max(dot(across, across), 1e-30)));
    // A surface that the device makes is one piece.
    let piece = select(pieces[number], TRIANGLE_BIT | triangle.part, (part.look & NO_SOURCES) != 0u);
    return Seen(id, part.object, piece, part.material, place, distance, normal, 0.0, 1.0);
}

fn draws(object: u32, kind: u32) -> bool {
    return (pens[pen_number(object, kind)].flags & DRAWS) != 0u;
}

fn found(kind: u32, share: f32, owned: bool) -> Edge {
    return Edge(kind, select(0.0, share, owned));
}

// Whether an object has a line where it runs into another; `turned` where the two do not look like one.
fn meets(object: u32, turned: bool) -> bool {
    let flags = styles[object].flags;
    return draws(object, SILHOUETTE) && ((flags & IMAGE_INK) != 0u || (turned && (flags & HYBRID_INK) != 0u));
}

// Where two objects run into each other, the later one of the scene has the line.
fn meeting(p: Seen, q: Seen, turned: bool, share: f32) -> Edge {
    return found(SILHOUETTE, share, meets(p.object, turned) && (p.object > q.object || !meets(q.object, turned)));
}

// The line that `p` has toward `q`, where one of them is a puff.
fn puff_edge(p: Seen, q: Seen) -> Edge {
    let is_image = (styles[p.object].flags & IMAGE_INK) != 0u;
    let nearer_radius = select(q.radius, p.radius, p.distance < q.distance);
    let step = (q.distance - p.distance) / select(max(p.radius, q.radius), nearer_radius, nearer_radius > 0.0);
    if p.object == q.object {
        // As with ink billboards: the farther apart puffs are, the wider.
        let style = styles[p.object];
        return found(SILHOUETTE, style.ink_inner * clamp(step - 2.0 * style.ink_offset, 0.0, 1.0), is_image);
    }
    if abs(step) > TOUCH {
        return found(SILHOUETTE, 1.0, is_image && step > 0.0);
    }
    let one_is_solid = p.radius == 0.0 || q.radius == 0.0;
    return meeting(p, q, one_is_solid, select(1.0 - abs(step) / TOUCH, 1.0, is_image));
}

// The same between triangles.
fn mesh_edge(p: Seen, q: Seen) -> Edge {
    let style = styles[p.object];
    let is_image = (style.flags & IMAGE_INK) != 0u;
    let apart = q.place - p.place;
    let off_plane = min(abs(dot(apart, p.normal)), abs(dot(apart, q.normal)));
    if off_plane > STEP_PX * min(p.distance, q.distance) / view.focal_px {
        return found(SILHOUETTE, 1.0, is_image && p.distance < q.distance);
    }
    let turn = dot(p.normal, q.normal);
    let merged = p.piece != q.piece && turn < TURN;
    if p.object != q.object {
        return meeting(p, q, merged, 1.0);
    }
    // Of two faces, the one that is seen better has the line: that does not change from pixel to pixel.
    let facing = vec2f(dot(p.normal, p.place - view.world_from_view[3].xyz), dot(q.normal, q.place - view.world_from_view[3].xyz));
    let owned = facing.x < facing.y || (facing.x == facing.y && p.id > q.id);
    if is_image && p.material != q.material && draws(p.object, MATERIAL) {
        return found(MATERIAL, 1.0, owned);
    }
    let has_crease = merged || (is_image && turn < style.ink_crease);
    return found(CREASE, 1.0, owned && has_crease && (style.flags & (IMAGE_INK | HYBRID_INK)) != 0u);
}

fn edge_of(p: Seen, q: Seen) -> Edge {
    if q.id == 0u {
        // Not where something that is drawn already hides how `p` goes on.
        return found(SILHOUETTE, 1.0, (styles[p.object].flags & IMAGE_INK) != 0u && q.distance > p.distance);
    }
    if p.radius > 0.0 || q.radius > 0.0 {
        return puff_edge(p, q);
    }
    return mesh_edge(p, q);
}

fn half_width_px(p: Seen, edge: Edge) -> f32 {
    let pen = pens[pen_number(p.object, edge.kind)];
    if edge.share == 0.0 || (pen.flags & DRAWS) == 0u {
        return 0.0;
    }
    let width = max(pen.width_px, pen.width_m * view.focal_px / p.distance);
    let tapered = width * edge.share * thinned(styles[p.object], p.normal, p.place);
    let kept = max(select(0.0, tapered, tapered >= THINNEST_PX || edge.share == 1.0), 0.0);
    return min(0.5 * select(0.0, max(kept, 1.0), kept > 0.0), image.radius_px);
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

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec2u {
    let px = vec2i(position.xy);
    let size = vec2i(textureDimensions(id_layer));
    let id = textureLoad(id_layer, px, 0).x;
    let ways = array(vec2i(-1, 0), vec2i(1, 0), vec2i(0, -1), vec2i(0, 1));
    var others = array(id, id, id, id);
    for (var way = 0; way < 4; way++) {
        others[way] = textureLoad(id_layer, clamp(px + ways[way], vec2i(0), size - 1), 0).x;
    }
    if id == 0u || all(vec4u(others[0], others[1], others[2], others[3]) == vec4u(id)) {
        discard;
    }
    let own = seen_at(id, px);
    var best = 0.0;
    var kind = SILHOUETTE;
    var aside = vec2i(0);
    for (var way = 0; way < 4; way++) {
        if others[way] == id {
            continue;
        }
        let edge = edge_of(own, seen_at(others[way], px + ways[way]));
        let half_width = half_width_px(own, edge);
        aside = select(aside, vec2i(0), half_width > best) + select(vec2i(0), ways[way], half_width >= best && half_width > 0.0);
        kind = select(kind, edge.kind, half_width > best);
        best = max(best, half_width);
    }
    // Ink of another method is there already.
    let is_image = (styles[own.object].flags & IMAGE_INK) != 0u;
    if best == 0.0 || (!is_image && textureLoad(ink_layer, px, 0).x != 0u) {
        discard;
    }
    mark_tiles(px, i32(ceil(best)) + 1, size);
    // A line an odd number of pixels wide has a middle pixel; others run between two.
    let is_odd = (i32(round(2.0 * best)) & 1) == 1;
    let mark = vec2u(pen_number(own.object, kind) + 1u, u32(round(255.0 * own.opacity)));
    return seed_of(px, select(aside, vec2i(0), is_odd), best, mark);
}
