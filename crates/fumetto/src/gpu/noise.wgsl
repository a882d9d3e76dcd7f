// Gradient noise with its gradient (Perlin 2002; derivatives after Quilez).

// A unit-ish gradient for a lattice point: a corner of a cube, so that components are ±1.
fn lattice_gradient(cell: vec3i, seed: u32) -> vec3f {
    let key = pcg(u32(cell.x) + pcg(u32(cell.y) + pcg(u32(cell.z) + seed)));
    return vec3f(vec3u(key, key >> 1u, key >> 2u) & vec3u(1u)) * 2.0 - 1.0;
}

// Perlin noise at `p`, lattice spacing 1: its gradient, then its value, which is within ±1.5.
fn noise(p: vec3f, seed: u32) -> vec4f {
    let cell = vec3i(floor(p));
    let w = p - floor(p);
    let u = w * w * w * (w * (w * 6.0 - 15.0) + 10.0);
    let du = 30.0 * w * w * (w * (w - 2.0) + 1.0);
    var result = vec4f(0.0);
    for (var corner = 0u; corner < 8u; corner++) {
        let at = vec3u(corner, corner >> 1u, corner >> 2u) & vec3u(1u);
        let offset = vec3f(at);
        let gradient = lattice_gradient(cell + vec3i(at), seed);
        let value = dot(gradient, w - offset);
        let weight = select(1.0 - u, u, at == vec3u(1u));
        let slope = select(-du, du, at == vec3u(1u));
        let share = weight.x * weight.y * weight.z;
        result += vec4f(gradient * share + value * slope * weight.yzx * weight.zxy, value * share);
    }
    return result;
}

// The gradient of Perlin noise at `p`, lattice spacing 1.
fn noise_gradient(p: vec3f, seed: u32) -> vec3f {
    return noise(p, seed).xyz;
}
