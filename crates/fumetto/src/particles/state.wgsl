// A simulated particle.
struct Particle {
    position: vec3f,
    // Seconds since birth.
    age: f32,
    velocity: vec3f,
    // Seconds from birth to death; zero before the first birth.
    life: f32,
    // Velocity at which vortices carried it in the last step, on top of its own.
    carried: vec3f,
    // At birth.
    radius: f32,
    mass: f32,
    // Number of its birth: what all its random choices come from.
    birth: u32,
}

fn alive(particle: Particle) -> bool {
    return particle.age < particle.life;
}
