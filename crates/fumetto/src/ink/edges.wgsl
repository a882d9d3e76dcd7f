// Finds the candidates whose lines may be seen from the camera.

@group(0) @binding(2) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(3) var<uniform> pens: array<Pen, MAX_PENS>;
@group(0) @binding(4) var<storage, read_write> flags: array<u32>;
@group(0) @binding(5) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(6) var<storage, read> parts: array<Part>;

// Whether all of a segment lies behind the near plane.
fn is_behind(segment: Segment) -> bool {
    let start = (view.view_from_world * vec4f(segment.start, 1.0)).z;
    let end = (view.view_from_world * vec4f(segment.end, 1.0)).z;
    return max(-start, -end) < view.near;
}

// Whether all of a segment lies behind the near plane, or beyond one side of the picture.
fn is_outside(segment: Segment) -> bool {
    let start = (view.view_from_world * vec4f(segment.start, 1.0)).xyz;
    let end = (view.view_from_world * vec4f(segment.end, 1.0)).xyz;
    if max(-start.z, -end.z) < view.near {
        return true;
    }
    // Half the widest that the line gets on the picture.
    let margin = pen_width_px(pens[segment.pen], max(min(-start.z, -end.z), view.near));
    // To the left and below, to the right and above.
    let middle = view.middle_px - view.first_px;
    let rest = view.size_px - middle;
    let to_low = (vec2f(middle.x, rest.y) + margin) / view.focal_px;
    let to_high = (vec2f(rest.x, middle.y) + margin) / view.focal_px;
    let low = (start.xy < to_low * start.z) & (end.xy < to_low * end.z);
    let high = (start.xy > -to_high * start.z) & (end.xy > -to_high * end.z);
    return any(low | high);
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = (group.y * groups.x + group.x) * 256u + lane;
    if index >= arrayLength(&flags) {
        return;
    }
    let candidate = candidate_at(index);
    let segment = segment_of(candidate);
    var kinds = 0u;
    if segment.pen != NO_PEN {
        let pen = pens[segment.pen];
        let kind = 1u << (segment.pen % KINDS);
        let dashed = (pen.flags & DASHES_HIDDEN) != 0u;
        let has_strokes = (pen.flags & HAS_STROKES) != 0u;
        let shows = (!segment.behind || dashed) && !is_outside(segment);
        // A contour may come through a corner, and goes on from there.
        let has_length = (candidate.bits & CONTOUR) != 0u || any(segment.start != segment.end);
        // Of strokes, what is hidden is drawn as plain lines are. Where they begin must not depend on what of them
        // the picture shows.
        kinds = select(0u, kind, shows && (dashed || !has_strokes))
            | select(0u, kind << KINDS, has_strokes && !segment.behind && !is_behind(segment) && has_length);
    }
    flags[index] = kinds;
}
