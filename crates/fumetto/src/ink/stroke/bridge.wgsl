// Closes gaps in what is seen of a line that are shorter than a stroke is high: triangles stand a little this way and
// that beside a contour.

@group(0) @binding(1) var<uniform> strokes: array<StrokeStyle, MAX_PENS>;
@group(0) @binding(2) var<uniform> tally: Tally;
@group(0) @binding(3) var<storage, read> joints: array<Joint>;
@group(0) @binding(4) var<storage, read> seen: array<u32>;
@group(0) @binding(5) var<storage, read_write> bridged: array<u32>;

// Longest gap, in heights.
const GAP: f32 = 1.5;
// Pieces that are looked at to each side.
const MOST_PIECES: u32 = 64u;

fn is_bridged(piece: u32) -> bool {
    let joint = joints[piece];
    if seen[piece] != 0u || piece == joint.last {
        return seen[piece] != 0u;
    }
    let gap = GAP * stroke_height_px(strokes[joint.pen], distance_of(joint.depth));
    var length = length_px(piece);
    var ahead = piece_after(piece);
    var back = piece_before(piece);
    for (var count = 0u; count < MOST_PIECES && length <= gap; count++) {
        if ahead == NONE || back == NONE {
            return false;
        }
        let ahead_seen = seen[ahead] != 0u;
        let back_seen = seen[back] != 0u;
        if ahead_seen && back_seen {
            return true;
        }
        if !ahead_seen {
            length += length_px(ahead);
            ahead = piece_after(ahead);
        }
        if !back_seen {
            length += length_px(back);
            back = piece_before(back);
        }
    }
    return false;
}

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x < tally.count {
        bridged[id.x] = u32(is_bridged(id.x));
    }
}
