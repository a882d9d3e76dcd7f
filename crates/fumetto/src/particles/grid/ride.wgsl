// Eddies go where their particles went, and turn as the air around them is sheared.

@group(0) @binding(0) var<uniform> eddies: Eddies;
@group(0) @binding(1) var<storage, read> particles: array<Particle>;
@group(0) @binding(2) var<storage, read_write> list: array<Eddy>;

// Along what the shear at an emitter's mouth turns, by the right hand about the jet; no two quite alike.
fn axis_at_birth(particle: Particle) -> vec3f {
    let key = pcg(particle.birth);
    let offset = particle.position - eddies.center;
    let any = 2.0 * vec3f(random(key, 20u), random(key, 21u), random(key, 22u)) - 1.0;
    let round = cross(eddies.blows, offset);
    let axis = round / max(length(round), 1e-6) + 0.7 * any;
    return axis / max(length(axis), 1e-6);
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = group.x * 256u + lane;
    if item >= eddies.count {
        return;
    }
    // Evenly among the particles: no product here comes near 2³².
    let every = eddies.particles / eddies.count;
    let particle = particles[item * every];
    var eddy = list[eddies.first + item];
    eddy.strength = 0.0;
    if alive(particle) {
        if eddy.birth != particle.birth + 1u {
            eddy.axis = axis_at_birth(particle);
        } else {
            // The air at both ends of a piece of axis turns it: the direction of ω in Dω/Dt = (ω·∇)u.
            let arm = 0.5 * eddies.radius * eddy.axis;
            let shear = velocity_at(particle.position + arm) - velocity_at(particle.position - arm);
            let turned = eddy.axis + (grid.dt / eddies.radius) * shear;
            eddy.axis = turned / max(length(turned), 1e-6);
        }
        eddy.strength = eddies.strength * (1.0 - particle.age / particle.life);
    }
    // Before the first birth all is zero: a number that no particle has there.
    eddy.birth = particle.birth + 1u;
    eddy.position = particle.position;
    list[eddies.first + item] = eddy;
}
