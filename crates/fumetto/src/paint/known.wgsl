// What bodies say of a place, one after the other, and what comes of it. Uses what `mask.wgsl` declares.

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
