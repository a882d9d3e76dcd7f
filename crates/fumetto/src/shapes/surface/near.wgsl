// The density of equation 2 near one place, from those particles of a list that reach its surroundings.

// So many of a list are told apart; what is beyond is always asked.
const TOLD: u32 = 128u;

struct Near {
    // The list.
    first: u32,
    end: u32,
    // Which of the first `TOLD` reach so far.
    reaching: array<u32, 4>,
}

// All that reaches within `around_m` of a place.
fn near(middle: vec3f, around_m: f32, list: vec2u) -> Near {
    var near = Near(list.x, list.y, array<u32, 4>());
    for (var word = 0u; word < 4u; word++) {
        let first = min(list.x + 32u * word, list.y);
        let end = min(first + 32u, list.y);
        var bits = 0u;
        for (var at = first; at < end; at++) {
            let blob = blobs[entries[at]];
            let off = middle - blob.center;
            let reach = blob.radius + around_m;
            bits |= select(0u, 1u << (at - first), dot(off, off) < reach * reach);
        }
        near.reaching[word] = bits;
    }
    return near;
}

// Gradient and value that one particle adds at a place.
fn density_of(blob: Blob, place: vec3f) -> vec4f {
    let off = place - blob.center;
    let fall = max(1.0 - dot(off, off) * blob.inverse_square, 0.0);
    return blob.mass * fall * vec4f(-4.0 * blob.inverse_square * off, fall);
}

// Equation 2, summed over all particles: gradient and value.
fn density_at(place: vec3f, near: Near) -> vec4f {
    var sum = vec4f(0.0);
    for (var word = 0u; word < 4u; word++) {
        for (var left = near.reaching[word]; left != 0u; left &= left - 1u) {
            let at = near.first + 32u * word + firstTrailingBit(left);
            sum += density_of(blobs[entries[at]], place);
        }
    }
    for (var at = near.first + TOLD; at < near.end; at++) {
        sum += density_of(blobs[entries[at]], place);
    }
    return sum;
}

fn field_at(place: vec3f, near: Near) -> vec4f {
    return field_of(density_at(place, near), place);
}
