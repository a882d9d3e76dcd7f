// Finds which ends meet, by a table of what tells them apart.
//
// Invocations race for places in the table, but what comes of it does not depend on who wins: all ends that meet are
// in one bucket, and each looks at all of them.

@group(0) @binding(0) var<uniform> tally: Tally;
@group(0) @binding(1) var<storage, read> records: array<Record>;
// An end + 1 for each bucket that is taken; in the second half, the last end that came into it, + 1.
@group(0) @binding(2) var<storage, read_write> table: array<atomic<u32>>;
// Of each end: its bucket, and the end + 1 that came into it before.
@group(0) @binding(3) var<storage, read_write> bucket: array<vec2u>;
// For each end the one that its line goes on with.
@group(0) @binding(4) var<storage, read_write> partner: array<u32>;

// Ends in one place of which pairs are found; where more meet, the model is broken.
const MOST_IN_ONE: u32 = 8u;
// Cosine of the angle at which a line along edges still goes on: a hand sets down anew at corners.
const STRAIGHT: f32 = 0.5;

// Ends have twice the number of their piece, and 1 more at its end.
fn told_apart(end: u32) -> vec3u {
    let record = records[end >> 1u];
    return vec3u(select(record.ends.xy, record.ends.zw, (end & 1u) == 1u), record.pen);
}

@compute @workgroup_size(256)
fn insert(@builtin(global_invocation_id) id: vec3u) {
    let buckets = arrayLength(&table) / 2u;
    for (var end = 2u * id.x; end < min(2u * id.x + 2u, 2u * tally.count); end++) {
        let own = told_apart(end);
        var at = pcg(own.x + pcg(own.y + pcg(own.z))) & (buckets - 1u);
        // The table has twice as many buckets as there can be ends.
        for (var tries = 0u; tries < buckets; tries++) {
            let was = atomicCompareExchangeWeak(&table[at], 0u, end + 1u);
            if was.exchanged || (was.old_value != 0u && all(told_apart(was.old_value - 1u) == own)) {
                break;
            }
            // A weak exchange may fail where nothing is.
            if was.old_value != 0u {
                at = (at + 1u) & (buckets - 1u);
            }
        }
        bucket[end] = vec2u(at, atomicExchange(&table[buckets + at], end + 1u));
    }
}

// Out of its piece at an end.
fn leaving(end: u32) -> vec3f {
    let direction = octahedral_unpacked(records[end >> 1u].direction);
    return select(-direction, direction, (end & 1u) == 1u);
}

// The end that goes on the straightest from one, among those where it is; NONE where there is none or too many.
fn straightest(end: u32) -> u32 {
    let own = leaving(end);
    var best = NONE;
    var best_cosine = -2.0;
    var count = 0u;
    var other = atomicLoad(&table[arrayLength(&table) / 2u + bucket[end].x]);
    while other != 0u {
        count++;
        if count > MOST_IN_ONE {
            return NONE;
        }
        let at = other - 1u;
        let cosine = -dot(own, leaving(at));
        let nearer = cosine > best_cosine || (cosine == best_cosine && at < best);
        if (at >> 1u) != (end >> 1u) && nearer {
            best = at;
            best_cosine = cosine;
        }
        other = bucket[at].y;
    }
    // A contour that comes to an edge goes on beyond it, however its pieces lie.
    let key = told_apart(end);
    return select(NONE, best, (key.x != key.y && count == 2u) || best_cosine > STRAIGHT);
}

@compute @workgroup_size(256)
fn pair(@builtin(global_invocation_id) id: vec3u) {
    for (var end = 2u * id.x; end < min(2u * id.x + 2u, 2u * tally.count); end++) {
        let best = straightest(end);
        var mutual = best != NONE;
        if mutual {
            mutual = straightest(best) == end;
        }
        partner[end] = select(NONE, best, mutual);
    }
}
