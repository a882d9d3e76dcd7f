// The models of the scene as they stand at the beginning. Uses `ground_cells` and `ground_corners` of the program
// that it is part of.

struct Ground {
    low: vec3f,
    // Side of a cell.
    cell: f32,
    counts: vec3u,
}

// Cells along each axis that are looked at for one piece of a particle's way: it is at most two wide, and the rest is
// the piece's length. There are enough of them to go through the whole grid in a step.
const MOST_CELLS: u32 = 8u;
const LONGEST_WAY: f32 = 4.0;
const MOST_PIECES: f32 = 32.0;

// Where something touches the ground.
struct Touch {
    place: vec3f,
    // How far the place is from it, or, where it came through a triangle, less than 0: the sooner the less.
    away: f32,
}

const NOWHERE: f32 = 1e30;

// The place of a triangle that is nearest (Ericson 2005, "Real-Time Collision Detection", section 5.1.5).
fn nearest_of(corners: array<vec3f, 3>, place: vec3f) -> vec3f {
    let ab = corners[1] - corners[0];
    let ac = corners[2] - corners[0];
    let ap = place - corners[0];
    let d1 = dot(ab, ap);
    let d2 = dot(ac, ap);
    if d1 <= 0.0 && d2 <= 0.0 {
        return corners[0];
    }
    let bp = place - corners[1];
    let d3 = dot(ab, bp);
    let d4 = dot(ac, bp);
    if d3 >= 0.0 && d4 <= d3 {
        return corners[1];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return corners[0] + ab * (d1 / max(d1 - d3, 1e-30));
    }
    let cp = place - corners[2];
    let d5 = dot(ab, cp);
    let d6 = dot(ac, cp);
    if d6 >= 0.0 && d5 <= d6 {
        return corners[2];
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return corners[0] + ac * (d2 / max(d2 - d6, 1e-30));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return corners[1] + (corners[2] - corners[1]) * ((d4 - d3) / max((d4 - d3) + (d5 - d6), 1e-30));
    }
    let all = max(va + vb + vc, 1e-30);
    return corners[0] + ab * (vb / all) + ac * (vc / all);
}

// How far along a way a triangle is met, or `NOWHERE` (Möller & Trumbore 1997).
fn met_at(corners: array<vec3f, 3>, start: vec3f, way: vec3f) -> f32 {
    let ab = corners[1] - corners[0];
    let ac = corners[2] - corners[0];
    let p = cross(way, ac);
    let det = dot(ab, p);
    if abs(det) < 1e-20 {
        return NOWHERE;
    }
    let from_corner = start - corners[0];
    let u = dot(from_corner, p) / det;
    let q = cross(from_corner, ab);
    let v = dot(way, q) / det;
    let t = dot(ac, q) / det;
    return select(NOWHERE, t, u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 && t <= 1.0);
}

fn ground_cell(place: vec3f) -> vec3u {
    let cell = floor((place - ground.low) / ground.cell);
    return vec3u(clamp(cell, vec3f(0.0), vec3f(ground.counts - 1u)));
}

// Adds what touches a ball in one piece of its way, which is short enough. With a radius below 0 only that counts
// which the middle comes through.
fn touch_on(way: vec3f, place: vec3f, radius: f32, before: Touch) -> Touch {
    var touch = before;
    let start = place - way;
    let room = max(radius, 0.0);
    let end = ground.low + vec3f(ground.counts) * ground.cell;
    if any(max(start, place) + room < ground.low) || any(min(start, place) - room > end) {
        return touch;
    }
    let first = ground_cell(min(start, place) - room);
    let last = min(ground_cell(max(start, place) + room), first + MOST_CELLS - 1u);
    for (var z = first.z; z <= last.z; z++) {
        for (var y = first.y; y <= last.y; y++) {
            for (var x = first.x; x <= last.x; x++) {
                let cell = (z * ground.counts.y + y) * ground.counts.x + x;
                for (var entry = ground_cells[cell]; entry < ground_cells[cell + 1u]; entry++) {
                    let corner = ground_cells[entry] * 3u;
                    let corners = array(
                        ground_corners[corner].xyz,
                        ground_corners[corner + 1u].xyz,
                        ground_corners[corner + 2u].xyz,
                    );
                    let met = met_at(corners, start, way);
                    let nearest = nearest_of(corners, place);
                    let away = distance(nearest, place);
                    if met <= 1.0 && met - 2.0 < touch.away {
                        touch = Touch(start + way * met, met - 2.0);
                    } else if away <= radius && away < touch.away {
                        touch = Touch(nearest, away);
                    }
                }
            }
        }
    }
    return touch;
}

// Whether and where a ball that came to `place` by a `way` touches the ground; `away` is `NOWHERE` if it does not.
fn touch_of(place: vec3f, radius: f32, way: vec3f) -> Touch {
    let pieces = clamp(ceil(length(way) / (LONGEST_WAY * ground.cell)), 1.0, MOST_PIECES);
    let piece = way / pieces;
    var touch = Touch(place, NOWHERE);
    for (var number = 1.0; number <= pieces && touch.away >= 0.0; number += 1.0) {
        let is_last = number == pieces;
        touch = touch_on(piece, place - way + piece * number, select(-1.0, radius, is_last), touch);
    }
    return touch;
}
