// Writes down the listed candidates' lines as the camera sees them.

@group(0) @binding(2) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(3) var<uniform> pens: array<Pen, MAX_PENS>;
@group(0) @binding(4) var<storage, read> list: array<u32>;
@group(0) @binding(5) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(6) var<storage, read> parts: array<Part>;
@group(0) @binding(7) var<uniform> strokes: array<StrokeStyle, MAX_PENS>;
@group(0) @binding(8) var<uniform> lights: Lights;
@group(0) @binding(9) var<uniform> tally: Tally;
// What stands for a vertex where ends meet: see `joints_of`.
@group(0) @binding(10) var<storage, read> seams: array<vec2u>;
@group(0) @binding(11) var<storage, read_write> records: array<Record>;

// Along this, closed lines begin where they reach least far: at their feet, a little to the left. No scene's axis
// lies along it, so that few have two such places.
const DOWN: vec3f = vec3f(0.36, 0.92, -0.15);

// From the top left of the picture, wherever what is drawn of it begins, so that its tiles agree.
fn place_of(position: vec3f) -> vec3f {
    let px = view.middle_px + vec2f(position.x, -position.y) * (view.focal_px / -position.z);
    return vec3f(px, depth_of(-position.z));
}

// Whole numbers in the order of the floats.
fn sortable(value: f32) -> u32 {
    let bits = bitcast<u32>(value);
    return select(bits | 0x80000000u, ~bits, (bits & 0x80000000u) != 0u);
}

fn square_to(direction: vec2f) -> vec2f {
    return direction / max(length(direction), 1e-9);
}

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= tally.count {
        return;
    }
    let candidate = candidate_at(list[id.x]);
    let segment = segment_of(candidate);
    let first = in_view(segment.start);
    let second = in_view(segment.end);
    // What lies before the near plane is cut off.
    let cut = clamp((-view.near - vec2f(first.z, second.z)) / vec2f(second.z - first.z, first.z - second.z), vec2f(0.0), vec2f(1.0));
    let from_view = select(first, mix(first, second, cut.x), -first.z < view.near);
    let to_view = select(second, mix(second, first, cut.y), -second.z < view.near);
    let start = place_of(from_view);
    let end = place_of(to_view);

    let middle = 0.5 * (segment.start + segment.end);
    let normal = octahedral_unpacked(vertices[candidate.left.x].normal)
        + octahedral_unpacked(vertices[candidate.left.y].normal)
        + octahedral_unpacked(vertices[candidate.left.z].normal);
    let away = select(normal, middle - vertices[candidate.left.z].position, (candidate.bits & (1u << BOUNDARY)) != 0u && segment.pen % KINDS == BOUNDARY);
    let seen = in_view(middle);
    let turned = (view.view_from_world * vec4f(away, 0.0)).xyz;
    // How a step that way moves on the picture.
    let outward = square_to(vec2f(turned.x, -turned.y) + vec2f(seen.x, -seen.y) * (turned.z / -seen.z));
    var lit = 0.0;
    if lights.count > 0u {
        lit = max(dot(normal / max(length(normal), 1e-6), toward(lights.light[0], middle)), 0.0);
    }
    let height_px = stroke_height_px(strokes[segment.pen], max(-0.5 * (from_view.z + to_view.z), view.near));
    let along = segment.end - segment.start;
    let straight = select(vec3f(0.0, 0.0, 1.0), along / length(along), dot(along, along) > 0.0);
    records[id.x] = Record(
        start,
        segment.pen,
        end,
        list[id.x],
        vec4u(meeting(segment.start_between), meeting(segment.end_between)),
        sortable(dot(middle, DOWN)),
        octahedral_packed(straight),
        pack2x16snorm(outward),
        pack2x16float(vec2f(lit, min(distance(start.xy, end.xy) / height_px, 6e4))),
    );
}
