// Paint that particles leave on what they touch: each has a place for its stain, which no other particle that lives
// at the same time has. So whoever comes first, the outcome is the same.

struct Touching {
    // Particles that there is room for, and of how many one leaves paint.
    capacity: u32,
    every: u32,
    // Particles alive at once that leave any, and stains for the place of each, one after the other.
    particles: u32,
    rounds: u32,
    // Number of this step, counted from 1.
    step: u32,
    dt: f32,
    // 1: a particle ends where it touches the ground.
    ends: u32,
    // A stain's radius over its particle's, and of that which it begins with; what both are multiplied with.
    size: f32,
    first: f32,
    scale: f32,
    // The particle's radius over life, sampled evenly from birth to death.
    radii: array<vec4f, 8>,
}

// A particle's paint.
struct Stain {
    // Where it first touched the ground, and where it did so last.
    start: vec3f,
    radius: f32,
    end: vec3f,
    birth: u32,
    // In which step it came; 0 while there is none.
    came: u32,
    // In which step it last touched the ground.
    touched: u32,
}

@group(0) @binding(0) var<uniform> touching: Touching;
@group(0) @binding(1) var<uniform> ground: Ground;
@group(0) @binding(2) var<storage, read> ground_cells: array<u32>;
@group(0) @binding(3) var<storage, read> ground_corners: array<vec4f>;
@group(0) @binding(4) var<storage, read_write> particles: array<Particle>;
@group(0) @binding(5) var<storage, read_write> stains: array<Stain>;
@group(0) @binding(6) var<storage, read_write> orders: array<Order>;

fn radius_at(particle: Particle) -> f32 {
    let at = clamp(particle.age / max(particle.life, 1e-6), 0.0, 1.0) * 31.0;
    let low = min(u32(at), 30u);
    let a = touching.radii[low / 4u][low % 4u];
    let b = touching.radii[(low + 1u) / 4u][(low + 1u) % 4u];
    return particle.radius * mix(a, b, at - f32(low));
}

@compute @workgroup_size(256)
fn touch(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let number = (group.y * groups.x + group.x) * 256u + lane;
    let slot = number * touching.every;
    if number >= touching.particles || slot >= touching.capacity {
        return;
    }
    let particle = particles[slot];
    if !alive(particle) {
        return;
    }
    let radius = radius_at(particle);
    let way = (particle.velocity + particle.carried) * min(touching.dt, particle.age);
    let found = touch_of(particle.position, radius, way);
    if found.away == NOWHERE {
        return;
    }
    let round = particle.birth / touching.capacity % touching.rounds;
    let index = round * touching.particles + number;
    // What ends there leaves its paint there; what goes on tints what it comes through.
    let place = select(particle.position, found.place, touching.ends == 1u);
    var stain = stains[index];
    if stain.came == 0u || stain.birth != particle.birth {
        stain = Stain(place, 0.0, place, particle.birth, touching.step, touching.step);
    }
    // What has left the ground for a while does not draw a line to where it comes back.
    if stain.touched + 1u >= touching.step {
        stain.end = place;
        stain.radius = max(stain.radius, touching.size * radius);
        stain.touched = touching.step;
    }
    stains[index] = stain;
    if touching.ends == 1u {
        particles[slot].age = particle.life;
    }
}

@compute @workgroup_size(256)
fn order(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = (group.y * groups.x + group.x) * 256u + lane;
    if index >= touching.particles * touching.rounds {
        return;
    }
    let stain = stains[index];
    let desired = stain.radius * touching.scale;
    let state = select(select(IS_THERE, COMES, stain.came == touching.step), 0u, stain.came == 0u);
    orders[index] = Order(stain.start, desired, stain.end, desired * touching.first, state);
}
