// Finds which pieces of lines are seen: those whose middle is.

@group(0) @binding(2) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(3) var<storage, read> joints: array<Joint>;
@group(0) @binding(4) var<storage, read_write> seen: array<u32>;
@group(0) @binding(5) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(6) var<storage, read> parts: array<Part>;
@group(0) @binding(7) var<uniform> tally: Tally;
@group(0) @binding(8) var depth_layer: texture_depth_2d;

fn is_seen(piece: u32) -> bool {
    let joint = joints[piece];
    if piece == joint.last {
        return false;
    }
    let next = joints[piece + 1u];
    let middle = 0.5 * (joint.px + next.px) - view.first_px;
    let depth = 0.5 * (joint.depth + next.depth);
    // Beyond the picture, strokes go on as they were.
    if any(middle < vec2f(0.0)) || any(middle >= view.size_px) {
        return true;
    }
    let candidate = candidate_at(joint.candidate);
    let right = select(candidate.left, candidate.right, (candidate.bits & PAIRED) != 0u);
    let range = depth_range(candidate.left);
    let nearest = max(range.y, depth_range(right).y);
    if (candidate.bits & CONTOUR) != 0u {
        // The outline of the triangles runs beside the contour, some part of one away.
        return !hides_contour(middle, nearest + 0.5 * (range.y - range.x));
    }
    return !hides_edge(middle, depth, depth_plane(candidate.left), depth_plane(right), nearest);
}

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x < tally.count {
        seen[id.x] = u32(is_seen(id.x));
    }
}
