// The field of Álvarez et al. 2007, and its gradient.

// Equation 2, summed over a list of particles: gradient and value.
fn density_at(place: vec3f, list: vec2u) -> vec4f {
    var sum = vec4f(0.0);
    for (var at = list.x; at < list.y; at++) {
        let blob = blobs[entries[at]];
        let off = place - blob.center;
        let fall = max(1.0 - dot(off, off) * blob.inverse_square, 0.0);
        sum += blob.mass * fall * vec4f(-4.0 * blob.inverse_square * off, fall);
    }
    return sum;
}

// Octaves of noise, each of half the size and strength, within ±1: gradient and value.
fn ripple_at(place: vec3f) -> vec4f {
    var sum = vec4f(0.0);
    var strength = 1.0;
    var most = 0.0;
    var per_m = recipe.noise_per_m;
    for (var octave = 0u; octave < recipe.noise_octaves; octave++) {
        sum += strength * noise(place * per_m, recipe.noise_seed + octave) * vec4f(vec3f(per_m), 1.0);
        most += 1.5 * strength;
        strength *= 0.5;
        per_m *= 2.0;
    }
    return sum / max(most, 1.0);
}

// Equation 3, and the noise added to it: gradient and value.
//
// Noise is added in full where the density reaches the threshold, and ever less toward the rim of the
// particles, so that none of it stands alone where there is no matter.
fn field_at(place: vec3f, list: vec2u) -> vec4f {
    let density = density_at(place, list);
    var field = density - vec4f(vec3f(0.0), recipe.threshold);
    if recipe.noise_amplitude > 0.0 && density.w > 0.0 {
        let share = min(density.w / recipe.threshold, 1.0);
        let hold = share * (2.0 - share);
        let hold_slope = 2.0 * (1.0 - share) / recipe.threshold;
        let ripple = recipe.noise_amplitude * recipe.threshold * ripple_at(place);
        field += vec4f(ripple.xyz * hold + density.xyz * (hold_slope * ripple.w), ripple.w * hold);
    }
    return field;
}
