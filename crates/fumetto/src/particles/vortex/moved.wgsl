// What moves smoke among vortices; goes with `step.wgsl`.

@group(0) @binding(3) var<storage, read> leaves: array<Leaf>;
@group(0) @binding(4) var<storage, read> nodes: array<Node>;

// Moves a particle for `dt` seconds: its own motion, and where vortices carry it meanwhile, as fast as they
// do half-way.
fn moved(start: Particle, dt: f32) -> Particle {
    var particle = start;
    let own = drift(start.velocity, air_at(start.position, start.age, step.forces), dt);
    particle.carried = induced(start.position + 0.5 * (own.shift + dt * start.carried), step.places);
    particle.position += own.shift + dt * particle.carried;
    particle.velocity = own.velocity;
    particle.age += dt;
    return particle;
}
