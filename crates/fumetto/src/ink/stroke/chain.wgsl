// Puts pieces of lines in order, by pointer jumping (Wyllie 1979): all that is known of the pieces up to some other is
// added to what is known of that one, so that each round looks twice as far as the one before.

@group(0) @binding(0) var<uniform> tally: Tally;
@group(0) @binding(1) var<storage, read> records: array<Record>;
@group(0) @binding(2) var<storage, read> partner: array<u32>;
// What the rounds read and write, in turn.
@group(0) @binding(3) var<storage, read> known: array<vec4u>;
@group(0) @binding(4) var<storage, read_write> learnt: array<vec4u>;
// Of each piece: whether it runs against its line, and the like.
@group(0) @binding(5) var<storage, read_write> turns: array<u32>;
// Joints of the line that begins with a piece; 0 where none does.
@group(0) @binding(6) var<storage, read_write> totals: array<u32>;

// Pieces are passed in two directions: as they are (arc 2n) and backward (2n + 1). What comes next, the least key so
// far, and whose that is.
@compute @workgroup_size(256)
fn begin(@builtin(global_invocation_id) id: vec3u) {
    if id.x < tally.count {
        let key = records[id.x].key;
        learnt[2u * id.x] = vec4u(partner[2u * id.x + 1u], key, 2u * id.x, 0u);
        learnt[2u * id.x + 1u] = vec4u(partner[2u * id.x], key, 2u * id.x + 1u, 0u);
    }
}

fn lesser(a: vec4u, b: vec4u) -> vec2u {
    return select(b.yz, a.yz, a.y < b.y || (a.y == b.y && a.z <= b.z));
}

@compute @workgroup_size(256)
fn seek(@builtin(global_invocation_id) id: vec3u) {
    for (var arc = 2u * id.x; arc < min(2u * id.x + 2u, 2u * tally.count); arc++) {
        var own = known[arc];
        if own.x != NONE {
            let next = known[own.x];
            own = vec4u(next.x, lesser(own, next), 0u);
        }
        learnt[arc] = own;
    }
}

// Who comes before each piece; then numbers for the second round of jumps: what comes before, joints and length up to
// the piece's end, the piece that is farthest back.
@compute @workgroup_size(256)
fn orient(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= tally.count {
        return;
    }
    let ahead = known[2u * id.x];
    let back = known[2u * id.x + 1u];
    // After as many rounds, only what has no end goes on.
    let is_closed = ahead.x != NONE;
    let least = lesser(ahead, back);
    let by_ahead = all(least == ahead.yz);
    // Lines run as their least piece does.
    let runs_back = by_ahead == ((least.y & 1u) == 1u);
    let is_head = is_closed && (least.y >> 1u) == id.x;
    let enters = partner[2u * id.x + u32(runs_back)];
    let leaves = partner[2u * id.x + 1u - u32(runs_back)];
    let before = select(enters >> 1u, NONE, enters == NONE || is_head);
    let is_tail = leaves == NONE || (is_closed && (leaves >> 1u) == (least.y >> 1u));
    turns[id.x] = select(0u, BACKWARD, runs_back) | select(0u, CLOSED, is_closed) | select(0u, TAIL, is_tail);
    totals[id.x] = 0u;
    let length = unpack2x16float(records[id.x].lit_length).y;
    learnt[id.x] = vec4u(before, joints_in(records[id.x]), bitcast<u32>(length), id.x);
}

@compute @workgroup_size(256)
fn rank(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= tally.count {
        return;
    }
    var own = known[id.x];
    if own.x != NONE {
        let before = known[own.x];
        let length = bitcast<f32>(own.z) + bitcast<f32>(before.z);
        own = vec4u(before.x, own.y + before.y, bitcast<u32>(length), before.w);
    }
    learnt[id.x] = own;
}

@compute @workgroup_size(256)
fn total(@builtin(global_invocation_id) id: vec3u) {
    if id.x < tally.count && (turns[id.x] & TAIL) != 0u {
        let own = known[id.x];
        totals[own.w] = own.y + 1u;
    }
}
