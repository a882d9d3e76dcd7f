// One fixed step of one emitter's particles: births, then motion. What `moved` is, the program's other modules say.

struct Step {
    // The step begins here, in seconds.
    time: f32,
    dt: f32,
    seed: u32,
    // Particles that there is room for.
    capacity: u32,
    // Number of the first birth of this step, how many there are, and how many of those come at once.
    first_birth: u32,
    births: u32,
    burst: u32,
    forces: u32,
    // 1: the dead are reborn, and first births are spread over `stagger` seconds from `begin`.
    reborn: u32,
    stagger: f32,
    begin: f32,
    until: f32,
    // 0 point, 1 disc, 2 sphere, 3 box, 4 line.
    shape: u32,
    spread_cos: f32,
    speed_jitter: f32,
    shape_radius: f32,
    center: vec4f,
    // Unit normal and share of the radius that is a hole, sides, or the line from `center`.
    extent: vec4f,
    velocity: vec4f,
    // Smallest and largest.
    life: vec2f,
    radius: vec2f,
    mass: vec2f,
    // Places in the vortices' tree; 0 without one.
    places: u32,
    pad: u32,
}

@group(0) @binding(0) var<uniform> step: Step;
@group(0) @binding(1) var<storage, read> forces: array<Force>;
@group(0) @binding(2) var<storage, read_write> particles: array<Particle>;

fn birth_place(key: u32) -> vec3f {
    let u = vec3f(random(key, 0u), random(key, 1u), random(key, 2u));
    switch step.shape {
        case 1u: {
            let hole = step.extent.w;
            let arm = sqrt(mix(hole * hole, 1.0, u.x)) * step.shape_radius * vec2f(cos(TAU * u.y), sin(TAU * u.y));
            return step.center.xyz + across(step.extent.xyz) * arm;
        }
        case 2u: {
            let z = 2.0 * u.x - 1.0;
            let ring = sqrt(max(1.0 - z * z, 0.0)) * vec2f(cos(TAU * u.y), sin(TAU * u.y));
            return step.center.xyz + vec3f(ring, z) * (step.shape_radius * pow(u.z, 1.0 / 3.0));
        }
        case 3u: { return step.center.xyz + (u - 0.5) * step.extent.xyz; }
        case 4u: { return step.center.xyz + u.x * step.extent.xyz; }
        default: { return step.center.xyz; }
    }
}

fn birth_velocity(key: u32) -> vec3f {
    let speed = length(step.velocity.xyz);
    if speed == 0.0 {
        return vec3f(0.0);
    }
    let axis = step.velocity.xyz / speed;
    let z = mix(1.0, step.spread_cos, random(key, 3u));
    let angle = TAU * random(key, 4u);
    let arm = sqrt(max(1.0 - z * z, 0.0)) * vec2f(cos(angle), sin(angle));
    let jitter = 1.0 + step.speed_jitter * (2.0 * random(key, 5u) - 1.0);
    return (axis * z + across(axis) * arm) * (speed * jitter);
}

fn born(birth: u32) -> Particle {
    let key = pcg(step.seed + pcg(birth));
    return Particle(
        birth_place(key),
        0.0,
        birth_velocity(key),
        mix(step.life.x, step.life.y, random(key, 6u)),
        vec3f(0.0),
        mix(step.radius.x, step.radius.y, random(key, 7u)),
        mix(step.mass.x, step.mass.y, random(key, 8u)),
        birth,
    );
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = (group.y * groups.x + group.x) * 256u + lane;
    if slot >= step.capacity {
        return;
    }
    let before = particles[slot];
    let end = step.time + step.dt;
    if step.reborn == 1u {
        let first = step.begin + step.stagger * f32(slot) / f32(step.capacity);
        let is_first = before.life == 0.0;
        let due = select(step.time + max(before.life - before.age, 0.0), first, is_first);
        if due < end && due >= step.begin && due < step.until {
            let birth = select(before.birth + step.capacity, slot, is_first);
            particles[slot] = moved(born(birth), end - max(due, step.time));
            return;
        }
    } else {
        // The one birth of this step, if any, that falls into this slot of the ring.
        let nth = (slot + step.capacity - step.first_birth % step.capacity) % step.capacity;
        if nth < step.births {
            // A stream's births are spread over the step, a burst's are not.
            let stream = f32(step.births - step.burst);
            let since = select((stream - f32(nth - step.burst) - 0.5) / stream, 1.0, nth < step.burst);
            particles[slot] = moved(born(step.first_birth + nth), step.dt * since);
            return;
        }
    }
    if alive(before) {
        particles[slot] = moved(before, step.dt);
    }
}
