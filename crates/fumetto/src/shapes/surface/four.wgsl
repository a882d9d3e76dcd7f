// Vectors by fours: what is read of a particle serves all of them. Reading is what costs most where a
// processor draws.
struct Four {
    x: vec4f,
    y: vec4f,
    z: vec4f,
}

// Sums of gradients and values of the density, in units.
struct Sums {
    x: vec4i,
    y: vec4i,
    z: vec4i,
    value: vec4f,
}

// Gradients and values of the field.
struct Fields {
    slope: Four,
    value: vec4f,
}

fn plus(a: Four, share: vec4f, b: Four) -> Four {
    return Four(a.x + share * b.x, a.y + share * b.y, a.z + share * b.z);
}

fn dots(a: Four, b: Four) -> vec4f {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

fn one_of(four: Four, index: u32) -> vec3f {
    return vec3f(four.x[index], four.y[index], four.z[index]);
}

// Adds what one particle has at four places (equation 2).
fn added(sum: Sums, blob: Blob, at: Four, per: Units) -> Sums {
    let off = Four(at.x - blob.center.x, at.y - blob.center.y, at.z - blob.center.z);
    let fall = max(1.0 - dots(off, off) * blob.inverse_square, vec4f(0.0));
    let steep = -4.0 * blob.mass * blob.inverse_square * per.slope * fall;
    let value = floor(blob.mass * per.density * fall * fall);
    return Sums(
        sum.x + vec4i(steep * off.x),
        sum.y + vec4i(steep * off.y),
        sum.z + vec4i(steep * off.z),
        min(sum.value + value, vec4f(FULL_UNITS)),
    );
}

// From sums to the field.
fn fields_of(sums: Sums, at: Four, units: Units) -> Fields {
    let density = sums.value * units.density;
    let slope = Four(vec4f(sums.x) * units.slope, vec4f(sums.y) * units.slope, vec4f(sums.z) * units.slope);
    if !NOISY {
        return Fields(slope, density - recipe.threshold);
    }
    var slopes = mat4x3f();
    var value = vec4f(0.0);
    for (var index = 0u; index < 4u; index++) {
        let field = field_of(vec4f(one_of(slope, index), density[index]), one_of(at, index));
        slopes[index] = field.xyz;
        value[index] = field.w;
    }
    let across = transpose(slopes);
    return Fields(Four(across[0], across[1], across[2]), value);
}

// What Newton's method divides by slopes: the density falls toward a particle's rim as a square, and its root, nearly
// straight, leads much closer to the surface. Not where there is hardly any.
fn rises(values: vec4f, threshold: f32) -> vec4f {
    let density = values + threshold;
    let of_root = 2.0 * (density - sqrt(max(density * threshold, vec4f(0.0))));
    return select(values, of_root, density > vec4f(0.0625 * threshold));
}

// The steps to the surface, as far as fields and gradients tell; at most `most` long.
fn steps_to_surface(fields: Fields, threshold: f32, most: f32) -> Four {
    let steep = max(sqrt(dots(fields.slope, fields.slope)), vec4f(FLAT));
    let length = clamp(-rises(fields.value, threshold) / steep, vec4f(-most), vec4f(most)) / steep;
    return Four(fields.slope.x * length, fields.slope.y * length, fields.slope.z * length);
}
