// Vectors by fours: what is read of a particle serves all of them. Reading is what costs most where a
// processor draws.
struct Four {
    x: vec4f,
    y: vec4f,
    z: vec4f,
}

// Gradients and values.
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
fn added(sum: Fields, blob: Blob, at: Four) -> Fields {
    let off = Four(at.x - blob.center.x, at.y - blob.center.y, at.z - blob.center.z);
    let fall = max(1.0 - dots(off, off) * blob.inverse_square, vec4f(0.0));
    let share = blob.mass * fall;
    return Fields(plus(sum.slope, -4.0 * blob.inverse_square * share, off), sum.value + share * fall);
}

fn no_fields() -> Fields {
    return Fields(Four(vec4f(0.0), vec4f(0.0), vec4f(0.0)), vec4f(0.0));
}

// From densities to the field.
fn fields_of(density: Fields, at: Four) -> Fields {
    if recipe.noise_amplitude == 0.0 {
        return Fields(density.slope, density.value - recipe.threshold);
    }
    var slope = mat4x3f();
    var value = vec4f(0.0);
    for (var index = 0u; index < 4u; index++) {
        let own = vec4f(one_of(density.slope, index), density.value[index]);
        let field = field_of(own, one_of(at, index));
        slope[index] = field.xyz;
        value[index] = field.w;
    }
    let across = transpose(slope);
    return Fields(Four(across[0], across[1], across[2]), value);
}

// The steps to the surface, as far as fields and gradients tell; at most `most` long.
fn steps_to_surface(fields: Fields, most: f32) -> Four {
    let steep = max(sqrt(dots(fields.slope, fields.slope)), vec4f(FLAT));
    let length = clamp(-fields.value / steep, vec4f(-most), vec4f(most)) / steep;
    return Four(fields.slope.x * length, fields.slope.y * length, fields.slope.z * length);
}
