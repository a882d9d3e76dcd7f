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
