// Moves one emitter's vortices, as smoke moves: by forces, and by each other.

struct Carry {
    dt: f32,
    forces: u32,
    // The first of them in the list, and how many there are.
    first: u32,
    count: u32,
    // Places in the tree.
    places: u32,
    // What a ring gets, and the seconds in which it gets it.
    circulation: f32,
    forming: f32,
    // Circulation a second for each m/s² of lift.
    growth: f32,
    // Share of circulation that dies, per second.
    decay: f32,
}

@group(0) @binding(0) var<uniform> carry: Carry;
@group(0) @binding(1) var<storage, read> forces: array<Force>;
@group(0) @binding(2) var<storage, read_write> vortices: array<Vortex>;
// Where vortices are in the middle of the step.
@group(0) @binding(3) var<storage, read_write> halfway: array<vec4f>;
@group(0) @binding(4) var<storage, read> leaves: array<Leaf>;
@group(0) @binding(5) var<storage, read> nodes: array<Node>;

// A vortex that got farther than the format's largest number is lost; in m.
const FARTHEST: f32 = 1e9;

fn slot_of(group: vec3u, lane: u32) -> u32 {
    return carry.first + group.x * 256u + lane;
}

fn is_ours(slot: u32) -> bool {
    return slot < carry.first + carry.count && spins(vortices[slot]);
}

@compute @workgroup_size(256)
fn predict(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = slot_of(group, lane);
    if is_ours(slot) {
        let vortex = vortices[slot];
        let air = air_at(vortex.position, vortex.age, carry.forces);
        let own = drift(vortex.velocity, air, 0.5 * carry.dt);
        let shift = own.shift + 0.5 * carry.dt * induced(vortex.position, carry.places);
        halfway[slot] = vec4f(vortex.position + shift, 0.0);
    }
}

// The acceleration by which what is warm rises.
fn lift_at(age: f32) -> f32 {
    var lift = 0.0;
    for (var i = 0u; i < carry.forces; i++) {
        if forces[i].kind == BUOYANCY {
            lift += forces[i].a.x * exp(-forces[i].a.y * max(age, 0.0));
        }
    }
    return lift;
}

// The midpoint method: with what there is in the middle of the step, all of it.
@compute @workgroup_size(256)
fn complete(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = slot_of(group, lane);
    if !is_ours(slot) {
        return;
    }
    var vortex = vortices[slot];
    let middle = halfway[slot].xyz;
    let air = air_at(middle, vortex.age + 0.5 * carry.dt, carry.forces);
    let own = drift(vortex.velocity, air, carry.dt);
    vortex.position += own.shift + carry.dt * induced(middle, carry.places);
    vortex.velocity = own.velocity;
    // Along the edge of what is warm, lift turns the air: ∂ω/∂t = ∇b × up has, across the edge, the integral
    // b times the height of edge that a ring stands for.
    var gain = carry.growth * lift_at(vortex.age) * carry.dt;
    if carry.forming > 0.0 {
        let end = min(vortex.age + carry.dt, carry.forming);
        gain += carry.circulation * max(end - max(vortex.age, 0.0), 0.0) / carry.forming;
    }
    vortex.circulation = vortex.circulation * exp(-carry.decay * carry.dt) + gain;
    vortex.age += carry.dt;
    if !(dot(vortex.position, vortex.position) < FARTHEST * FARTHEST) {
        vortex = Vortex();
    }
    vortices[slot] = vortex;
}
