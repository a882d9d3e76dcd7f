// Samples the air of `air.wgsl` around many places; goes behind `random`, `noise` and `air`.

struct Probe {
    // 0 turbulence, 1 vortex.
    kind: u32,
    octaves: u32,
    // Distance of the six places around each, for central differences.
    step: f32,
    count: u32,
}

@group(0) @binding(0) var<uniform> probe: Probe;
@group(0) @binding(1) var<storage, read> forces: array<Force>;
// Velocity; then its divergence and the root of the sum of its derivatives' squares.
@group(0) @binding(2) var<storage, read_write> found: array<vec4f>;

fn air_velocity(p: vec3f) -> vec3f {
    if probe.kind == 0u {
        return curl(p, vec3f(0.31, -0.2, 0.77), probe.octaves, 1234u);
    }
    return swirl(p, vec3f(32.0), normalize(vec3f(1.0, 2.0, -1.0)), 12.0, 5.0);
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= probe.count {
        return;
    }
    // On a fine lattice within 64 m, so that places a power of two apart are exact.
    let p = floor(65536.0 * vec3f(random(item, 0u), random(item, 1u), random(item, 2u))) / 1024.0;
    let h = probe.step;
    let x = (air_velocity(p + vec3f(h, 0.0, 0.0)) - air_velocity(p - vec3f(h, 0.0, 0.0))) / (2.0 * h);
    let y = (air_velocity(p + vec3f(0.0, h, 0.0)) - air_velocity(p - vec3f(0.0, h, 0.0))) / (2.0 * h);
    let z = (air_velocity(p + vec3f(0.0, 0.0, h)) - air_velocity(p - vec3f(0.0, 0.0, h))) / (2.0 * h);
    found[2u * item] = vec4f(air_velocity(p), 0.0);
    found[2u * item + 1u] = vec4f(x.x + y.y + z.z, sqrt(dot(x, x) + dot(y, y) + dot(z, z)), 0.0, 0.0);
}
