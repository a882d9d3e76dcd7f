// A vortex particle in the grid (Selle, Rasmussen & Fedkiw 2005). It rides on a particle of smoke.
struct Eddy {
    position: vec3f,
    // Acceleration where it pushes most, in m/s²; zero: it is not there.
    strength: f32,
    // Its axis; it turns by the right hand.
    axis: vec3f,
    // The particle's number.
    birth: u32,
}

struct Eddies {
    // The emitter's first in the list, how many it has, and how many there are of all.
    first: u32,
    count: u32,
    all: u32,
    // Particles among which they are spread evenly.
    particles: u32,
    // The middle of the emitter's shape, and which way it blows.
    center: vec3f,
    radius: f32,
    blows: vec3f,
    strength: f32,
}
