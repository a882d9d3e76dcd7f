// Which volumes of paint what is seen lies in, and on whose edge: a workgroup for each tile of the picture.
//
// ten Bosch counts volumes in the stencil buffer. Here a place is asked: is it nearer to the axis of a volume than
// the volume's radius in its direction? The answer is the same, from wherever it is seen: there is no surface that a
// camera could come through, no count that could overflow, and no triangle that could be seen at the border.

@group(0) @binding(1) var<uniform> coats: Coats;
@group(0) @binding(2) var<uniform> icosahedron: Icosahedron;
@group(0) @binding(3) var depth_layer: texture_depth_2d;
@group(0) @binding(4) var<storage, read> bodies: array<Body>;
@group(0) @binding(5) var<storage, read> vertices: array<vec2f>;
@group(0) @binding(6) var<storage, read> directions: array<vec4f>;
@group(0) @binding(7) var<storage, read> patches: array<u32>;
// Two pixels a word, row after row.
@group(0) @binding(8) var<storage, read_write> mask: array<u32>;

// Pixels of a tile along x and y; each invocation has two of them. A software rasteriser gives up a loop after 65,535
// rounds in all: so few pixels, and no loop within those over bodies, leave room for all that a scene may have. It also
// runs what an `if` keeps out, and every loop once: so there is one loop over bodies, which asks for a radius in one
// place.
const TILE_PX: vec2u = vec2u(16u, 16u);
const LANES: u32 = 128u;

// Room for as many bodies as a scene may have, 32 to a word, and for a bit for each of these words.
const HITS: u32 = 512u;
const SUMMARY: u32 = HITS / 32u;

// No place that is seen.
const NOWHERE: f32 = 1e30;

// Lines on surfaces that are seen almost edge-on are looked for only so far away, in their widths.
const STEEPEST: f32 = 6.0;

// Bodies that run into each other do so over this many times the length that they do.
const BLENDS: f32 = 4.0;

var<workgroup> lows: array<vec3f, LANES>;
var<workgroup> highs: array<vec3f, LANES>;
var<workgroup> hits: array<atomic<u32>, HITS>;
var<workgroup> summary: array<atomic<u32>, SUMMARY>;
// A bit for each word of the summary that has any.
var<workgroup> parts: atomic<u32>;
// A bit for each layer of which one body holds all that the tile shows.
var<workgroup> whole: atomic<u32>;

fn distance_at(px: vec2u) -> f32 {
    let depth = textureLoad(depth_layer, min(px, textureDimensions(depth_layer) - 1u), 0);
    return select(0.0, distance_of(depth), depth > 0.0);
}

fn place_at(px: vec2u, distance: f32) -> vec3f {
    return (view.world_from_view * vec4f(ray_of(vec2f(px) + 0.5) * distance, 1.0)).xyz;
}

fn is_drawn(px: vec2u) -> bool {
    return all(px < vec2u(view.size_px));
}

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

// What is known of a place so far. Bodies come in the order of their paints and of the layers of these.
struct Known {
    bits: u32,
    coat: u32,
    layer: u32,
    // Of the layer that is asked: how far outside of its nearest body the place is, and which way out.
    outside: f32,
    outward: vec3f,
    // Of those of its bodies that run into each other, the sum of exp(-outside / blend), and likewise outward.
    sum: f32,
    sum_outward: vec3f,
    blend: f32,
    // Of the outermost layer of the paint that is asked.
    edge: f32,
    edge_outward: vec3f,
    // Number of the paint whose line there is, counted from 1.
    line: u32,
}

// Whether an edge runs through a pixel, whose neighbours are so far away in space: a line is as wide on the picture
// whatever the angle is at which the surface and the volume meet.
fn is_on_line(known: Known, distance: f32, right: vec3f, down: vec3f) -> bool {
    let per_px = length(vec2f(dot(known.edge_outward, right), dot(known.edge_outward, down)));
    let line_px = line_at(known.coat, distance) * view.focal_px / distance;
    return abs(known.edge) < line_px * per_px;
}

// Adds what a body says of a place.
fn ask(body: Body, place: vec3f, distance: f32, known: ptr<function, Known>) {
    let coat = body.coat;
    if any(place < coats.coats[coat].keep_low) || any(place > coats.coats[coat].keep_high) {
        return;
    }
    let axis = body.end - body.start;
    let along = clamp(dot(place - body.start, axis) / max(dot(axis, axis), 1e-20), 0.0, 1.0);
    let away = place - body.start - along * axis;
    let apart = length(away);
    let band = STEEPEST * line_at(coat, distance) + BLENDS * body.blend;
    // What is known to lie deep inside stays there, whatever else it lies in.
    if apart >= body.far + band || (*known).outside < -band {
        return;
    }
    let outward = away / max(apart, 1e-20);
    let blends = body.blend > 0.0;
    var outside = apart - body.near;
    if blends || outside >= -band {
        outside = apart - radius_of(body, outward);
    }
    if blends {
        let share = exp(-outside / body.blend);
        (*known).sum += share;
        (*known).sum_outward += share * outward;
        (*known).blend = body.blend;
    } else if outside < (*known).outside {
        (*known).outside = outside;
        (*known).outward = outward;
    }
}

// All bodies of a layer have been asked.
fn end_layer(known: ptr<function, Known>) {
    var outside = (*known).outside;
    var outward = (*known).outward;
    if (*known).sum > 0.0 {
        let blended = -(*known).blend * log((*known).sum);
        outward = select(outward, (*known).sum_outward / (*known).sum, blended < outside);
        outside = min(outside, blended);
    }
    if outside < 0.0 {
        (*known).bits |= 1u << (*known).layer;
    }
    // Of washes, the outermost has the line.
    let is_outermost = (coats.coats[(*known).coat].bits & ((1u << (*known).layer) - 1u)) == 0u;
    if is_outermost {
        (*known).edge = outside;
        (*known).edge_outward = outward;
    }
    (*known).outside = NOWHERE;
    (*known).sum = 0.0;
    (*known).sum_outward = vec3f(0.0);
}

// All layers of a paint have been asked. Lines of paints that lie below are drawn first.
fn end_coat(distance: f32, right: vec3f, down: vec3f, known: ptr<function, Known>) {
    if (*known).edge < NOWHERE && is_on_line(*known, distance, right, down) {
        (*known).line = (*known).coat + 1u;
    }
    (*known).edge = NOWHERE;
}

// From a pixel to the next one along an axis: to the neighbour that is about as deep.
fn step_from(px: vec2u, place: vec3f, distance: f32, axis: vec2u) -> vec3f {
    let ahead = distance_at(px + axis);
    let behind = distance_at(px - min(axis, px));
    let is_ahead = ahead > 0.0 && (behind == 0.0 || abs(ahead - distance) <= abs(behind - distance));
    if is_ahead {
        return place_at(px + axis, ahead) - place;
    }
    return place - place_at(px - min(axis, px), select(distance, behind, behind > 0.0));
}

// What is known of a pixel, in 16 bits.
fn asked(px: vec2u) -> u32 {
    let distance = distance_at(px);
    if distance == 0.0 || !is_drawn(px) {
        return 0u;
    }
    let place = place_at(px, distance);
    var known: Known;
    known.outside = NOWHERE;
    known.edge = NOWHERE;
    let right = step_from(px, place, distance, vec2u(1u, 0u));
    let down = step_from(px, place, distance, vec2u(0u, 1u));
    known.bits = atomicLoad(&whole);
    var parts_left = atomicLoad(&parts);
    var part = 0u;
    var words = 0u;
    var word = 0u;
    var numbers = 0u;
    while (parts_left | words | numbers) != 0u {
        if (words | numbers) == 0u {
            part = firstTrailingBit(parts_left);
            parts_left &= parts_left - 1u;
            words = atomicLoad(&summary[part]);
        }
        if numbers == 0u {
            word = part * 32u + firstTrailingBit(words);
            words &= words - 1u;
            numbers = atomicLoad(&hits[word]);
        }
        let number = word * 32u + firstTrailingBit(numbers);
        numbers &= numbers - 1u;
        let body = bodies[number];
        if body.layer != known.layer {
            end_layer(&known);
            known.layer = body.layer;
        }
        if body.coat != known.coat {
            end_coat(distance, right, down, &known);
            known.coat = body.coat;
        }
        ask(body, place, distance, &known);
    }
    end_layer(&known);
    end_coat(distance, right, down, &known);
    return known.bits | (known.line << LAYER_BITS);
}

@compute @workgroup_size(LANES)
fn main(@builtin(workgroup_id) id: vec3u, @builtin(local_invocation_index) lane: u32) {
    let words = TILE_PX.x / 2u;
    let px = id.xy * TILE_PX + vec2u(lane % words * 2u, lane / words);
    measure(px, lane);
    find(lane);
    if is_drawn(px) {
        let row = (u32(view.size_px.x) + 1u) / 2u;
        mask[px.y * row + px.x / 2u] = asked(px) | (asked(px + vec2u(1u, 0u)) << 16u);
    }
}
