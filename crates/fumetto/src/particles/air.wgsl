// What moves a particle: the velocity of the air around it, and accelerations of its own.

struct Force {
    a: vec4f,
    b: vec4f,
    kind: u32,
    octaves: u32,
    seed: u32,
    pad: u32,
}

const GRAVITY: u32 = 0u;
const BUOYANCY: u32 = 1u;
const DRAG: u32 = 2u;
const WIND: u32 = 3u;
const TURBULENCE: u32 = 4u;
const VORTEX: u32 = 5u;
const ATTRACT: u32 = 6u;

// What `curl` must be multiplied with to have a root mean square of 1 (measured over 4·10⁶ places).
const CURL_TO_UNIT: f32 = 0.548;

// A divergence-free swirl: the cross product of two gradients is the curl of a·∇b (cf. Bridson et al.
// 2007, "Curl-noise for procedural fluid flow", who take the curl of three noises).
fn curl(p: vec3f, travel: vec3f, octaves: u32, seed: u32) -> vec3f {
    var sum = vec3f(0.0);
    var power = 0.0;
    for (var octave = 0u; octave < octaves; octave++) {
        let frequency = f32(1u << octave);
        let key = seed + octave * 2u;
        // The two potentials drift apart, so that the swirls change as they travel.
        let a = noise_gradient((p - travel) * frequency, key);
        let b = noise_gradient((p + 0.5 * travel) * frequency + 17.3, key + 1u);
        sum += cross(a, b) / frequency;
        power += 1.0 / (frequency * frequency);
    }
    return sum * (CURL_TO_UNIT / sqrt(power));
}

// Turns around an axis, fastest at `radius`: solid in the middle, free far out.
fn swirl(p: vec3f, center: vec3f, axis: vec3f, radius: f32, speed: f32) -> vec3f {
    let offset = p - center;
    let arm = (offset - axis * dot(offset, axis)) / radius;
    return cross(axis, arm) * (2.0 * speed / (1.0 + dot(arm, arm)));
}

struct Air {
    velocity: vec3f,
    acceleration: vec3f,
    // Rate of drag toward `velocity`, per second.
    drag: f32,
}

fn air_at(p: vec3f, age: f32, count: u32) -> Air {
    var air = Air(vec3f(0.0), vec3f(0.0), 0.0);
    for (var i = 0u; i < count; i++) {
        let force = forces[i];
        switch force.kind {
            case GRAVITY: { air.acceleration += force.a.xyz; }
            case BUOYANCY: { air.acceleration.y += force.a.x * exp(-force.a.y * age); }
            case DRAG: { air.drag += force.a.x; }
            case WIND: { air.velocity += force.a.xyz; }
            case TURBULENCE: {
                air.velocity += force.a.w * curl(p * force.b.w, force.b.xyz, force.octaves, force.seed);
            }
            case VORTEX: { air.velocity += swirl(p, force.a.xyz, force.b.xyz, force.a.w, force.b.w); }
            case ATTRACT: {
                let arm = (force.a.xyz - p) / force.a.w;
                // Grows to its full strength at the radius and falls off beyond; no jump at the centre.
                air.acceleration += arm * (2.0 * force.b.x / (1.0 + dot(arm, arm)));
            }
            default: {}
        }
    }
    return air;
}
