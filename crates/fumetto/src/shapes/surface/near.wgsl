// The density of equation 2 near one place, from those particles of a list that reach its surroundings.

// So many of a list are told apart; what is beyond is always asked.
const TOLD: u32 = 128u;

struct Near {
    // The list.
    first: u32,
    end: u32,
    // Which of the first `TOLD` reach so far.
    reaching: array<u32, 4>,
    units: Units,
}

// Gradient and value of the density, in units.
struct Sum {
    slope: vec3i,
    value: f32,
}

// All that reaches within `around_m` of a place.
fn near(middle: vec3f, around_m: f32, list: vec2u, units: Units) -> Near {
    var near = Near(list.x, list.y, array<u32, 4>(), units);
    for (var word = 0u; word < 4u; word++) {
        let first = min(list.x + 32u * word, list.y);
        let end = min(first + 32u, list.y);
        var bits = 0u;
        for (var at = first; at < end; at++) {
            let blob = unpacked(blobs[entries[at]]);
            let off = middle - blob.center;
            let reach = blob.radius + around_m;
            bits |= select(0u, 1u << (at - first), dot(off, off) < reach * reach);
        }
        near.reaching[word] = bits;
    }
    return near;
}

// Adds what one particle has at a place.
fn added_at(sum: Sum, blob: Blob, place: vec3f, units: Units) -> Sum {
    let off = place - blob.center;
    let fall = max(1.0 - dot(off, off) * blob.inverse_square, 0.0);
    let slope = -4.0 * blob.mass * blob.inverse_square / units.slope * fall * off;
    let value = floor(blob.mass / units.density * fall * fall);
    return Sum(sum.slope + vec3i(slope), min(sum.value + value, FULL_UNITS));
}

// Equation 2, summed over all particles: gradient and value.
fn density_at(place: vec3f, near: Near) -> vec4f {
    var sum = Sum();
    for (var word = 0u; word < 4u; word++) {
        for (var left = near.reaching[word]; left != 0u; left &= left - 1u) {
            let at = near.first + 32u * word + firstTrailingBit(left);
            sum = added_at(sum, unpacked(blobs[entries[at]]), place, near.units);
        }
    }
    for (var at = near.first + TOLD; at < near.end; at++) {
        sum = added_at(sum, unpacked(blobs[entries[at]]), place, near.units);
    }
    return vec4f(vec3f(sum.slope) * near.units.slope, sum.value * near.units.density);
}

fn field_at(place: vec3f, near: Near) -> vec4f {
    return field_of(density_at(place, near), place);
}
