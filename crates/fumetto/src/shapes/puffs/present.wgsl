// Turns particles into puffs: what is drawn of them at their age.

struct Present {
    capacity: u32,
    // Where in the list of puffs this emitter's begin.
    first: u32,
    object: u32,
    first_variant: u32,
    variants: u32,
    // The puff's radius over the particle's.
    size: f32,
    seed: u32,
    pad: u32,
    // Radius, mass, erosion and opacity over life, sampled evenly from birth to death.
    curves: array<vec4f, 33>,
}

@group(0) @binding(0) var<uniform> present: Present;
@group(0) @binding(1) var<storage, read> particles: array<Particle>;
@group(0) @binding(2) var<storage, read_write> puffs: array<Puff>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = (group.y * groups.x + group.x) * 256u + lane;
    if slot >= present.capacity {
        return;
    }
    let particle = particles[slot];
    let at = clamp(particle.age / max(particle.life, 1e-6), 0.0, 1.0) * 32.0;
    let low = min(u32(at), 31u);
    let now = mix(present.curves[low], present.curves[low + 1u], at - f32(low));
    let radius = select(0.0, particle.radius * now.x * present.size, alive(particle));
    puffs[present.first + slot] = Puff(
        particle.position,
        radius,
        puff_look(particle.birth, present.seed, present.first_variant, present.variants, present.object),
        pack2x16unorm(now.zw),
        particle.mass * now.y,
        0.0,
    );
}
