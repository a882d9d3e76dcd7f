// The line of a candidate as it is seen from the camera.
//
// The surface turns away from the viewer where its normal is square to the line of sight. Between vertices both
// are taken to change linearly, so that the contour is straight in each triangle (Hertzmann & Zorin,
// "Illustrating Smooth Surfaces", 2000), and goes on in the next from the very same place. Along an edge where
// normals differ from side to side, it runs where one side is turned to the viewer and the other is not: from
// where the contour of the left side ends to where that of the right side does.

struct Segment {
    // In the world.
    start: vec3f,
    end: vec3f,
    // Number of the pen, or NO_PEN where there is no line.
    pen: u32,
    // Whether nothing of the surface at the line is seen, because both triangles show their unseen side.
    behind: bool,
    // The vertices between which the start lies, and the end; twice the same where it is at one.
    start_between: vec2u,
    end_between: vec2u,
}

const NO_PEN: u32 = 0xffffffffu;

// Width of a line at a distance, in pixels.
fn pen_width_px(pen: Pen, distance: f32) -> f32 {
    return max(pen.width_px, pen.width_m * view.focal_px / distance);
}

// How far the surface is turned to the viewer at a vertex; below zero, it is turned away.
fn turned_to_viewer(vertex: Vertex) -> f32 {
    return dot(octahedral_unpacked(vertex.normal), view.world_from_view[3].xyz - vertex.position);
}

// Where it is neither, between two vertices. Both triangles at an edge ask from the same end, and so get the
// same answer bit by bit.
fn turning_point(a: vec3f, turned_a: f32, b: vec3f, turned_b: f32) -> vec3f {
    if turned_a < 0.0 {
        return mix(a, b, turned_a / (turned_a - turned_b));
    }
    return mix(b, a, turned_b / (turned_b - turned_a));
}

// The first pen that draws, among those whose kinds have a bit.
fn pen_of(object: u32, kinds: u32) -> u32 {
    let order = array(SILHOUETTE, BOUNDARY, CREASE, MATERIAL);
    for (var rank = 0; rank < 4; rank++) {
        let kind = order[rank];
        let number = pen_number(object, kind);
        if (kinds & (1u << kind)) != 0u && (pens[number].flags & FOLLOWS_EDGES) != 0u {
            return number;
        }
    }
    return NO_PEN;
}

fn contour_of(candidate: Candidate) -> Segment {
    let nothing = Segment(vec3f(0.0), vec3f(0.0), NO_PEN, false, vec2u(0u), vec2u(0u));
    let pen = pen_of(candidate_object(candidate), 1u << SILHOUETTE);
    if pen == NO_PEN {
        return nothing;
    }
    let a = vertices[candidate.left.x];
    let b = vertices[candidate.left.y];
    let c = vertices[candidate.left.z];
    let turned = vec3f(turned_to_viewer(a), turned_to_viewer(b), turned_to_viewer(c));
    let away = turned < vec3f(0.0);
    if all(away) || !any(away) {
        return nothing;
    }
    // Two of its sides are crossed: those at the corner that differs from the others. What is turned to the viewer
    // lies on the line's left.
    let corners = candidate.left;
    let ab = turning_point(a.position, turned.x, b.position, turned.y);
    let bc = turning_point(b.position, turned.y, c.position, turned.z);
    let ca = turning_point(c.position, turned.z, a.position, turned.x);
    if away.y == away.z {
        return ordered(Segment(ca, ab, pen, false, corners.zx, corners.xy), away.x);
    }
    if away.x == away.z {
        return ordered(Segment(ab, bc, pen, false, corners.xy, corners.yz), away.y);
    }
    return ordered(Segment(bc, ca, pen, false, corners.yz, corners.zx), away.z);
}

fn ordered(segment: Segment, keeps: bool) -> Segment {
    if keeps {
        return segment;
    }
    return Segment(segment.end, segment.start, segment.pen, segment.behind, segment.end_between, segment.start_between);
}

fn edge_of(candidate: Candidate) -> Segment {
    let object = candidate_object(candidate);
    let a = vertices[candidate.left.x];
    let b = vertices[candidate.left.y];
    let kinds = candidate.bits & ~CONTOUR & 15u;
    let at_a = candidate.left.xx;
    let at_b = candidate.left.yy;
    let left = vec2f(turned_to_viewer(a), turned_to_viewer(b));
    let left_unseen = (candidate.bits & LEFT_ONE_SIDED) != 0u && left.x + left.y < 0.0;
    if (candidate.bits & PAIRED) == 0u {
        return Segment(a.position, b.position, pen_of(object, kinds), left_unseen, at_a, at_b);
    }
    let sign = select(1.0, -1.0, (candidate.bits & FLIPPED) != 0u);
    let right = vec2f(turned_to_viewer(vertices[candidate.right.x]), turned_to_viewer(vertices[candidate.right.y]));
    let right_unseen = (candidate.bits & RIGHT_ONE_SIDED) != 0u && right.x + right.y < 0.0;
    let behind = left_unseen && right_unseen;
    // As seen from the left triangle's front.
    let facing = sign * right;
    let differs = (left < vec2f(0.0)) != (facing < vec2f(0.0));
    let differs_in_the_middle = (left.x + left.y < 0.0) != (facing.x + facing.y < 0.0);
    if (candidate.bits & HARD) != 0u && (any(differs) || differs_in_the_middle) {
        let silhouette = pen_of(object, 1u << SILHOUETTE);
        let otherwise = pen_of(object, kinds);
        if otherwise != NO_PEN {
            return Segment(a.position, b.position, select(otherwise, silhouette, differs_in_the_middle && silhouette != NO_PEN), behind, at_a, at_b);
        }
        let left_end = turning_point(a.position, left.x, b.position, left.y);
        let right_end = turning_point(a.position, facing.x, b.position, facing.y);
        let left_turns = (left.x < 0.0) != (left.y < 0.0);
        let crossing = select(right_end, left_end, left_turns);
        let at_crossing = select(candidate.right.xy, candidate.left.xy, left_turns);
        if all(differs) {
            return Segment(a.position, b.position, silhouette, behind, at_a, at_b);
        }
        if differs.x {
            return Segment(a.position, crossing, silhouette, behind, at_a, at_crossing);
        }
        if differs.y {
            return Segment(crossing, b.position, silhouette, behind, at_crossing, at_b);
        }
        return Segment(left_end, right_end, silhouette, behind, candidate.left.xy, candidate.right.xy);
    }
    return Segment(a.position, b.position, pen_of(object, kinds), behind, at_a, at_b);
}

fn segment_of(candidate: Candidate) -> Segment {
    if (candidate.bits & CONTOUR) != 0u {
        return contour_of(candidate);
    }
    return edge_of(candidate);
}
