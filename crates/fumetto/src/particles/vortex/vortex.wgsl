// A vortex particle: a piece of the line of a vortex ring. Its neighbours in the list are its neighbours in
// the ring, which tells the piece's length and direction.
struct Vortex {
    position: vec3f,
    // Seconds since birth; below zero in the step in which it is born.
    age: f32,
    // Its own, as smoke has one. What vortices do to each other comes on top.
    velocity: vec3f,
    // Seconds from birth to death; zero before the first birth.
    life: f32,
    // In m²/s.
    circulation: f32,
    // Radius of the line, in metres, at birth.
    core: f32,
    // Of the piece at birth, in metres.
    length: f32,
    pad: u32,
}

fn spins(vortex: Vortex) -> bool {
    return vortex.age < vortex.life;
}
