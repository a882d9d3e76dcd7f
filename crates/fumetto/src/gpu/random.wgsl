// Random numbers from integers, the same on every adapter.

// PCG-RXS-M-XS-32 (O'Neill 2014; as a hash: Jarzynski & Olano, JCGT 2020).
fn pcg(input: u32) -> u32 {
    let state = input * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// The `k`-th random number of `key`, in [0, 1).
fn random(key: u32, k: u32) -> f32 {
    return f32(pcg(key + pcg(k)) >> 8u) * (1.0 / 16777216.0);
}
