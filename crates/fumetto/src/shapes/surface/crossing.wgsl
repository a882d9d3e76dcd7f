// Finds a vertex with care, one at a time: for edges where a few steps of Newton's method do not do.

// Newton converges in three or four steps; where it can only halve, so many leave 1/1024 of a cell.
const STEPS: u32 = 10u;
// A step of so little of a cell is the last: the next one's error is its square.
const CONVERGED: f32 = 1e-3;
// Likewise where the place is only one to start from.
const ROUGH: f32 = 0.03;

struct Crossing {
    // How far along the edge.
    at: f32,
    // The field near there, where the last step began.
    field: vec4f,
}

// Where on the edge the field is zero, to within `tolerance`: Newton's method from `at` on, kept within what
// is known to hold the root.
fn crossing(edge: Edge, from_at: f32, tolerance: f32, near: Near) -> Crossing {
    var low = 0.0;
    var high = 1.0;
    var found = Crossing(from_at, vec4f(0.0));
    for (var step = 0u; step < STEPS; step++) {
        let at = found.at;
        let field = field_at(edge.start + at * edge.along, near);
        if (field.w > 0.0) == edge.inside {
            low = at;
        } else {
            high = at;
        }
        let slope = dot(field.xyz, edge.along);
        var next = 0.5 * (low + high);
        if abs(slope) > FLAT {
            let newton = at - field.w / slope;
            if abs(newton - at) < tolerance {
                return Crossing(clamp(newton, 0.0, 1.0), field);
            }
            next = select(next, newton, newton > low && newton < high);
        }
        found = Crossing(next, field);
    }
    return found;
}

// The step from a place to the surface, as far as field and gradient there tell; at most `most` long.
fn step_to_surface(field: vec4f, most: f32) -> vec3f {
    let steepness = length(field.xyz);
    if steepness <= FLAT {
        return vec3f(0.0);
    }
    return field.xyz / steepness * clamp(-field.w / steepness, -most, most);
}

struct Sample {
    place: vec3f,
    field: vec4f,
}

// Away from the edge's end, within the surface's tangent plane, and from there back to the surface.
fn slid(edge: Edge, crossed: Crossing, away: vec3f, near: Near) -> Sample {
    let normal = crossed.field.xyz / length(crossed.field.xyz);
    var place = edge.start + crossed.at * edge.along + away - normal * dot(normal, away);
    var field = field_at(place, near);
    for (var step = 0u; step < 2u; step++) {
        let back = step_to_surface(field, length(away));
        if length(back) < 0.1 * CONVERGED * near.units.cell_m {
            break;
        }
        place += back;
        field = field_at(place, near);
    }
    return Sample(place, field);
}

fn surface_near(edge: Edge, near: Near) -> Sample {
    let rough = crossing(edge, 0.5, ROUGH, near);
    let away = clamp(rough.at, CLEAR, 1.0 - CLEAR) - rough.at;
    if away != 0.0 && length(rough.field.xyz) > FLAT {
        let slid = slid(edge, rough, away * edge.along, near);
        // Not where the surface bends so much that it was missed.
        let cell_m = near.units.cell_m;
        let missed = length(step_to_surface(slid.field, cell_m));
        let off = distance(slid.place, edge.start + 0.5 * edge.along);
        if missed < CONVERGED * cell_m && off < AROUND * cell_m && length(slid.field.xyz) > FLAT {
            return slid;
        }
    }
    let place = edge.start + crossing(edge, rough.at, CONVERGED, near).at * edge.along;
    return Sample(place, field_at(place, near));
}

fn outward(field: vec4f, edge: Edge) -> vec3f {
    let steepness = length(field.xyz);
    if steepness > FLAT {
        return -field.xyz / steepness;
    }
    return select(-1.0, 1.0, edge.inside) * normalize(edge.along);
}
