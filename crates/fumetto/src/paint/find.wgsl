// Which bodies come near what a tile shows: all others are asked nothing. Uses what `mask.wgsl` declares.

// The box around all that a tile shows; as `lows[0]` and `highs[0]`. An invocation's pixels begin at `first`.
fn measure(first: vec2u, lane: u32) {
    var low = vec3f(NOWHERE);
    var high = vec3f(-NOWHERE);
    for (var side = 0u; side < 2u; side++) {
        let px = first + vec2u(side, 0u);
        let distance = distance_at(px);
        if distance > 0.0 && is_drawn(px) {
            let place = place_at(px, distance);
            low = min(low, place);
            high = max(high, place);
        }
    }
    lows[lane] = low;
    highs[lane] = high;
    for (var half = LANES / 2u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if lane < half {
            lows[lane] = min(lows[lane], lows[lane + half]);
            highs[lane] = max(highs[lane], highs[lane + half]);
        }
    }
    workgroupBarrier();
}

// Half the width of a paint's line at a distance, in metres.
fn line_at(coat: u32, distance: f32) -> f32 {
    return max(coats.coats[coat].line_px * distance / view.focal_px, coats.coats[coat].line_m);
}

// How near a body comes to what a tile shows.
struct Reach {
    // Whether its border may lie there, or the line along it.
    is_near: bool,
    // Whether all lies deep inside of it.
    holds_all: bool,
}

fn reach_of(body: Body, low: vec3f, high: vec3f, farthest: f32) -> Reach {
    let coat = body.coat;
    let band = STEEPEST * line_at(coat, farthest) + BLENDS * body.blend;
    let reach = body.far + band;
    let keep_low = coats.coats[coat].keep_low;
    let keep_high = coats.coats[coat].keep_high;
    let ends_low = max(min(body.start, body.end) - reach, keep_low);
    let ends_high = min(max(body.start, body.end) + reach, keep_high);
    // Of a ball around all that is shown, the nearest and the farthest place.
    let middle = 0.5 * (low + high);
    let half = 0.5 * length(high - low);
    let axis = body.end - body.start;
    let along = clamp(dot(middle - body.start, axis) / max(dot(axis, axis), 1e-20), 0.0, 1.0);
    let apart = distance(middle, body.start + along * axis);
    let meets = all(ends_low <= high) && all(ends_high >= low) && apart - half <= reach;
    let is_kept = all(low >= keep_low) && all(high <= keep_high);
    let is_there = body.far > 0.0 && low.x <= high.x;
    return Reach(is_there && meets, is_there && is_kept && apart + half < body.near - band);
}

// Notes the bodies that have to be asked about what the tile shows.
fn find(lane: u32) {
    for (var word = lane; word < HITS; word += LANES) {
        atomicStore(&hits[word], 0u);
    }
    if lane < SUMMARY {
        atomicStore(&summary[lane], 0u);
    }
    if lane == 0u {
        atomicStore(&parts, 0u);
        atomicStore(&whole, 0u);
    }
    workgroupBarrier();
    let low = lows[0];
    let high = highs[0];
    let eye = view.world_from_view[3].xyz;
    let farthest = length(max(abs(low - eye), abs(high - eye)));
    for (var number = lane; number < coats.bodies; number += LANES) {
        let body = bodies[number];
        if reach_of(body, low, high, farthest).holds_all {
            atomicOr(&whole, 1u << body.layer);
        }
    }
    workgroupBarrier();
    let known = atomicLoad(&whole);
    for (var number = lane; number < coats.bodies; number += LANES) {
        let body = bodies[number];
        if (known & (1u << body.layer)) == 0u && reach_of(body, low, high, farthest).is_near {
            atomicOr(&hits[number / 32u], 1u << (number % 32u));
            atomicOr(&summary[number / 1024u], 1u << (number / 32u % 32u));
            atomicOr(&parts, 1u << (number / 1024u));
        }
    }
    workgroupBarrier();
}
