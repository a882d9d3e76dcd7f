// Turns lines into what a hand draws along: smooth, in runs that are worth a stroke.
//
// Contours zigzag by some part of a triangle. They are averaged over about the height of the stroke, over the same
// length to both sides, so that ends stay where they are; and only over what is seen, for where a contour turns back
// at a cusp, it is hidden.

@group(0) @binding(1) var<uniform> strokes: array<StrokeStyle, MAX_PENS>;
@group(0) @binding(2) var<uniform> tally: Tally;
@group(0) @binding(3) var<storage, read> joints: array<Joint>;
@group(0) @binding(4) var<storage, read> bridged: array<u32>;
@group(0) @binding(5) var<storage, read_write> shapes: array<Shape>;

// How far contours are averaged to each side, in heights, and in pixels at least.
const RADIUS: f32 = 0.8;
const LEAST_RADIUS_PX: f32 = 3.0;
// Strokes shorter than this are dots, and closed ones are that many times as long to be worth drawing.
const LEAST_PX: f32 = 1.0;
const CLOSED_LONGER: f32 = 3.0;
// How far to each side of a place its bend is told from, in heights: a hand does not press for every wrinkle.
const BEND_REACH: f32 = 4.0;
// Pieces that are looked at to each side, for an average and for a run.
const MOST_AVERAGED: u32 = 64u;
const MOST_IN_RUN: u32 = 256u;

// What lies to one side of a joint: the mean place, and the length that it is over.
struct Side {
    mean: vec2f,
    length: f32,
}

// The first piece to one side of a joint.
fn first_piece(joint: u32, ahead: bool) -> u32 {
    let own = joints[joint];
    if ahead {
        if joint < own.last {
            return joint;
        }
        return select(NONE, own.first, own.is_closed != 0u);
    }
    return piece_before(joint);
}

fn next_piece(piece: u32, ahead: bool) -> u32 {
    if ahead {
        return piece_after(piece);
    }
    return piece_before(piece);
}

fn side_of(joint: u32, ahead: bool, radius: f32) -> Side {
    var sum = vec2f(0.0);
    var weights = 0.0;
    var length = 0.0;
    var piece = first_piece(joint, ahead);
    for (var count = 0u; count < MOST_AVERAGED && piece != NONE && length < radius; count++) {
        if bridged[piece] == 0u {
            break;
        }
        let whole = length_px(piece);
        let used = min(whole, radius - length);
        // The middle of what is used of it.
        let share = 0.5 * used / max(whole, 1e-6);
        let middle = mix(joints[piece].px, joints[piece + 1u].px, select(1.0 - share, share, ahead));
        let far = (length + 0.5 * used) / radius;
        let weight = used * (1.0 - far * far);
        sum += weight * middle;
        weights += weight;
        length += used;
        piece = next_piece(piece, ahead);
    }
    return Side(select(joints[joint].px, sum / weights, weights > 0.0), length);
}

// Pixels to one side of a piece in which its line is seen, up to a limit.
fn run_px(piece: u32, ahead: bool, limit: f32) -> f32 {
    var length = 0.0;
    var at = next_piece(piece, ahead);
    for (var count = 0u; count < MOST_IN_RUN && length < limit; count++) {
        // Once round, there is no end.
        if at == piece {
            return limit;
        }
        if at == NONE {
            return length;
        }
        if bridged[at] == 0u {
            return length;
        }
        length += length_px(at);
        at = next_piece(at, ahead);
    }
    return limit;
}

fn unit(direction: vec2f) -> vec2f {
    return direction / max(length(direction), 1e-6);
}

// One over the radius in which a line bends, in pixels.
fn bend_at(joint: u32, radius: f32) -> f32 {
    let ahead = side_of(joint, true, radius);
    let back = side_of(joint, false, radius);
    let both = min(ahead.length, back.length);
    let px = joints[joint].px;
    let turn = unit(ahead.mean - px) - unit(px - back.mean);
    // Toward an end, less and less is known of it.
    let known = smoothstep(0.0, radius, both);
    return known * length(turn) / max(0.5 * distance(ahead.mean, back.mean), 1.0);
}

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= tally.count {
        return;
    }
    let joint = joints[id.x];
    let style = strokes[joint.pen];
    let height = stroke_height_px(style, distance_of(joint.depth));
    var shape = Shape(joint.px, vec2f(0.0), 0.0, 0.0, 0.0, 0u);
    let is_contour = joint.pen % KINDS == SILHOUETTE;
    let radius = max(RADIUS * height, LEAST_RADIUS_PX);
    var ahead = side_of(id.x, true, radius);
    var back = side_of(id.x, false, radius);
    shape.tangent = unit(ahead.mean - back.mean);
    let both = min(ahead.length, back.length);
    if both > 0.0 {
        ahead = side_of(id.x, true, both);
        back = side_of(id.x, false, both);
        shape.bend = bend_at(id.x, BEND_REACH * height);
        if is_contour {
            shape.px = 0.5 * joint.px + 0.25 * (ahead.mean + back.mean);
        }
    }
    if id.x < joint.last && bridged[id.x] != 0u {
        let limit = sight_px(style, height);
        shape.before = run_px(id.x, false, limit);
        shape.after = run_px(id.x, true, limit);
        let run = shape.before + length_px(id.x) + shape.after;
        // A closed line has no end, and may yet be small: a dent that is seen from aside.
        let whole = select(run, joints[joint.last].along * height / CLOSED_LONGER, joint.is_closed != 0u);
        shape.shows = u32(min(run, whole) >= max(style.shortest_px, LEAST_PX));
    }
    shapes[id.x] = shape;
}
