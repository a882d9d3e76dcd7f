// The field of Álvarez et al. 2007 and the noise that is added to it, from the density of equation 2.

// Whether there is noise at all: kernels without are smaller, and a processor that draws goes through all of a kernel.
override NOISY: bool = true;

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

// Equation 3, and the noise added to it, from gradient and value of the density at a place: gradient and
// value.
//
// Noise is added in full where the density reaches the threshold, and ever less toward the rim of the
// particles, so that none of it stands alone where there is no matter.
fn field_of(density: vec4f, place: vec3f) -> vec4f {
    var field = density - vec4f(vec3f(0.0), recipe.threshold);
    if NOISY && density.w > 0.0 {
        let share = min(density.w / recipe.threshold, 1.0);
        let hold = share * (2.0 - share);
        let hold_slope = 2.0 * (1.0 - share) / recipe.threshold;
        let ripple = recipe.noise_amplitude * recipe.threshold * ripple_at(place - recipe.noise_offset_m);
        field += vec4f(ripple.xyz * hold + density.xyz * (hold_slope * ripple.w), ripple.w * hold);
    }
    return field;
}
