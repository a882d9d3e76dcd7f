// Draws lines found on models: each segment as a strip with round ends, so that strips which share an end meet
// in a round corner.
//
// What hides a line is asked of the depth layer at the line's own middle, not at the pixel: the outer half of a
// silhouette would else be compared with what lies behind, the inner half with the surface that bulges out.

@group(0) @binding(2) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(3) var<uniform> pens: array<Pen, MAX_PENS>;
@group(0) @binding(4) var<storage, read> list: array<u32>;
@group(0) @binding(5) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(6) var<storage, read> parts: array<Part>;
@group(0) @binding(7) var id_layer: texture_2d<u32>;
@group(0) @binding(8) var depth_layer: texture_depth_2d;
@group(0) @binding(9) var<uniform> lights: Lights;

struct Corner {
    @builtin(position) position: vec4f,
    // Start and end of the middle line, in pixels.
    @location(0) @interpolate(flat) middle: vec4f,
    // Half the width at both, depth at both.
    @location(1) @interpolate(flat) ends: vec4f,
    // Depth of the planes on both sides, to be multiplied by a pixel's ray; the last numbers are the depth that
    // they do not exceed, and the lengths of dashes and gaps together.
    @location(2) @interpolate(flat) left: vec4f,
    @location(3) @interpolate(flat) right: vec4f,
    // Pen; the bits below.
    @location(4) @interpolate(flat) marks: vec2u,
}

// Both triangles show the side that is not seen.
const UNSEEN: u32 = 1u;
const DASHES_START: u32 = 2u;
const CONTOUR_MARK: u32 = 4u;

// Lengths of dashes and gaps of hidden lines, in widths, where the pen has no others.
const HIDDEN_DASH: vec2f = vec2f(4.0, 3.0);

// Share of the first light that falls on the surface between two vertices.
fn lit_between(a: Vertex, b: Vertex) -> f32 {
    let normal = octahedral_unpacked(a.normal) + octahedral_unpacked(b.normal);
    if lights.count == 0u {
        return 0.0;
    }
    return max(dot(normal / max(length(normal), 1e-6), toward(lights.light[0], a.position)), 0.0);
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let place = strip_corner(index);
    let candidate = candidate_at(list[place.x]);
    let segment = segment_of(candidate);
    let pen = pens[segment.pen];
    let first = in_view(segment.start);
    let second = in_view(segment.end);
    // What lies before the near plane is cut off.
    let cut = clamp((-view.near - vec2f(first.z, second.z)) / vec2f(second.z - first.z, first.z - second.z), vec2f(0.0), vec2f(1.0));
    let start = select(first, mix(first, second, cut.x), -first.z < view.near);
    let end = select(second, mix(second, first, cut.y), -second.z < view.near);
    let middle = vec4f(px_of(start), px_of(end));
    let is_contour = (candidate.bits & CONTOUR) != 0u;
    let right = select(candidate.left, candidate.right, (candidate.bits & PAIRED) != 0u);
    let lit = vec2f(
        lit_between(vertices[candidate.left.x], vertices[right.x]),
        lit_between(vertices[candidate.left.y], vertices[right.y]),
    );
    let thinned = 1.0 - pen.lit_thinning * select(lit, vec2f(0.5 * (lit.x + lit.y)), is_contour);
    // A line that is thinner than a sample would break.
    let widths = thinned * vec2f(pen_width_px(pen, -start.z), pen_width_px(pen, -end.z));
    let is_gone = all(thinned < vec2f(FINEST));
    let half_widths = select(max(0.5 * widths, vec2f(0.5)), vec2f(0.0), is_gone);
    let depths = vec2f(depth_of(-start.z), depth_of(-end.z));

    let range = depth_range(candidate.left);
    var nearest = max(range.y, depth_range(right).y);
    if is_contour {
        // The outline of the triangles runs beside the contour, some part of one away.
        nearest += 0.5 * (range.y - range.x);
    }

    let along = middle.zw - middle.xy;
    let distance = length(along);
    let direction = select(vec2f(1.0, 0.0), along / distance, distance > 1e-6);
    let period = pen.dash_px.x + pen.dash_px.y;
    let marks = select(0u, UNSEEN, segment.behind)
        | select(0u, DASHES_START, !is_contour && distance >= period)
        | select(0u, CONTOUR_MARK, is_contour);
    let corner = place.y;
    let at_end = corner == 1u || corner == 2u;
    let side = select(-1.0, 1.0, corner >= 2u);
    let reach = select(max(half_widths.x, half_widths.y) + 0.5, 0.0, is_gone);
    let outward = reach * (direction * select(-1.0, 1.0, at_end) + vec2f(-direction.y, direction.x) * side);
    return Corner(
        clip_of(select(middle.xy, middle.zw, at_end) + outward, 0.5),
        middle,
        vec4f(half_widths, depths),
        vec4f(depth_plane(candidate.left), nearest),
        vec4f(depth_plane(right), period),
        vec2u(segment.pen, marks),
    );
}

// Whether something lies before a place of the line's middle.
fn is_hidden(middle: vec2f, depth: f32, corner: Corner) -> bool {
    if (corner.marks.y & CONTOUR_MARK) != 0u {
        return hides_contour(middle, corner.left.w);
    }
    return hides_edge(middle, depth, corner.left.xyz, corner.right.xyz, corner.left.w);
}

// Whether a dash covers a place on the middle line, `share` of the way to the segment's end.
fn is_dashed(corner: Corner, middle: vec2f, share: f32, dash_px: vec2f) -> bool {
    let along = corner.middle.zw - corner.middle.xy;
    // Short segments go on where the one before them ended, or nearly: by the axis that they run along.
    let from_corner = middle + view.first_px;
    let across = select(from_corner.y, from_corner.x, abs(along.x) > abs(along.y));
    let place = select(across, share * length(along), (corner.marks.y & DASHES_START) != 0u);
    let period = dash_px.x + dash_px.y;
    return place - floor(place / period) * period < dash_px.x;
}

struct Mark {
    @location(0) mark: vec2u,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(corner: Corner) -> Mark {
    let px = corner.position.xy;
    let along = corner.middle.zw - corner.middle.xy;
    let share = clamp(dot(px - corner.middle.xy, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
    let middle = corner.middle.xy + share * along;
    let half_width = mix(corner.ends.x, corner.ends.y, share);
    if distance(px, middle) > half_width {
        discard;
    }
    let pen = pens[corner.marks.x];
    let depth = mix(corner.ends.z, corner.ends.w, share);
    let own = textureLoad(depth_layer, vec2i(px), 0);
    let id = textureLoad(id_layer, vec2i(px), 0).x;
    let bulge = select(OWN_BULGE, OTHER_BULGE, is_other(id, corner.marks.x / KINDS));
    // A share of the distance: so many pixels, one metre away.
    let before = own > depth * (1.0 + DEPTH_TOLERANCE + bulge * half_width / view.focal_px);
    let hidden = (corner.marks.y & UNSEEN) != 0u || before || is_hidden(middle, depth, corner);
    var rank = RANKS[corner.marks.x % KINDS];
    if hidden {
        let dashes = (pen.flags & DASHES_HIDDEN) != 0u;
        let own_dash = all(pen.dash_px > vec2f(0.0));
        if !dashes || !is_dashed(corner, middle, share, select(HIDDEN_DASH * 2.0 * half_width, pen.dash_px, own_dash)) {
            discard;
        }
        rank = 0.0;
    } else if (pen.flags & HAS_STROKES) != 0u {
        // What is seen of it is drawn as a stroke.
        discard;
    } else if corner.right.w > 0.0 && !is_dashed(corner, middle, share, pen.dash_px) {
        discard;
    }
    // Over all that it has been found to lie before, or let through.
    let claim = select(depth, corner.left.w, (corner.marks.y & CONTOUR_MARK) != 0u && !hidden);
    let over = max(own, claim) * (1.0 + RANK_STEP * (0.5 + rank));
    return Mark(vec2u(corner.marks.x + 1u, 255u), min(over, 1.0));
}
