// Paints over a cel and its ink: chooses how each pixel is drawn by the paint that it lies in (ten Bosch, section 3).
//
// Of one pass, the paper keeps the grey in alpha; here grey is worked out where it is asked for. Where regions have
// styles of their own, the layers were shaded once for each, and this picks.

@group(0) @binding(0) var<uniform> compose: Compose;
@group(0) @binding(1) var<uniform> pens: array<Pen, MAX_PENS>;
@group(0) @binding(2) var<uniform> coats: Coats;
@group(0) @binding(3) var<uniform> reveal: Reveal;
@group(0) @binding(4) var cel: texture_2d<f32>;
@group(0) @binding(5) var ink: texture_2d<u32>;
@group(0) @binding(6) var around: texture_2d<f32>;
@group(0) @binding(7) var before: texture_2d<f32>;
@group(0) @binding(8) var linear: sampler;
@group(0) @binding(9) var<storage, read> mask: array<u32>;

struct Reveal {
    // In which `cel` and `ink` are drawn; what is drawn in another one is taken from `before`.
    look: u32,
}

// The topmost paint at a pixel, counted from 1; 0 where there is none.
fn topmost(marks: u32) -> u32 {
    var top = 0u;
    for (var coat = 0u; coat < coats.count; coat++) {
        top = select(top, coat + 1u, (marks & coats.coats[coat].bits) != 0u);
    }
    return top;
}

// Encoded colour with all washes that lie over it, from the lowest paint to the topmost. k of them with strength s
// of the colour T leave of the colour c, linear: glazed c (1 - s + s T)^k, covered c (1 - s)^k + T (1 - (1 - s)^k).
fn washed(colour: vec3f, marks: u32) -> vec3f {
    var light = decoded(colour);
    var is_washed = false;
    for (var number = 0u; number < coats.count; number++) {
        let coat = coats.coats[number];
        let washes = countOneBits(marks & coat.bits);
        for (var k = 0u; k < washes; k++) {
            let glazed = light * mix(vec3f(1.0), coat.wash_colour, coat.wash_strength);
            let covered = mix(light, coat.wash_colour, coat.wash_strength);
            light = select(glazed, covered, (coat.flags & COVERS) != 0u);
            is_washed |= coat.wash_strength > 0.0;
        }
    }
    // What no wash touches stays just as it was picked.
    return select(colour, encoded(light), is_washed);
}

// The cel with its ink; straight alpha, encoded. Where nothing is mixed, colours stay just as they were picked.
fn drawn_at(at: vec2i) -> vec4f {
    let cel = textureLoad(cel, at, 0);
    let line = line_at(at);
    if line.share == 0.0 || line.share == 1.0 {
        return select(cel, line.colour, line.share == 1.0);
    }
    let sum = inked(cel, line);
    return select(vec4f(0.0), vec4f(encoded(sum.rgb / sum.a), sum.a), sum.a > 0.0);
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let px = vec2u(position.xy);
    let marks = marks_at(px, textureDimensions(cel).x);
    let top = topmost(marks);
    var look = coats.look;
    var flags = coats.flags;
    if top != 0u {
        look = coats.coats[top - 1u].look;
        flags = coats.coats[top - 1u].flags;
    }
    if look != reveal.look {
        return textureLoad(before, px, 0);
    }
    var drawn = drawn_at(vec2i(px));
    if (flags & MONOCHROME) != 0u {
        drawn = vec4f(monochrome(drawn.rgb), drawn.a);
    }
    drawn = vec4f(washed(drawn.rgb, marks), drawn.a);
    let edge = marks >> LAYER_BITS;
    if edge != 0u && drawn.a > 0.0 {
        return vec4f(coats.coats[edge - 1u].line_colour, drawn.a);
    }
    return drawn;
}
