// How volumes spread (ten Bosch, section 2). Every vertex is a particle that moves along its ray from the volume's
// axis: pressure drives it to the desired radius, which the grain of the ground makes uneven; elasticity pulls it
// back to where it was at first; friction takes its speed; gravity pulls. So a volume is always whole: rays do not
// cross, and no count can be broken. The axis' far end runs as gravity and the surface have it, by the same law.
//
// Euler's method in parts of the step, speed first: then it neither explodes nor overshoots where the parts are
// short enough (see `Spread::substeps`).

struct Group {
    volumes: u32,
    // Of each volume.
    vertices: u32,
    first_body: u32,
    first_vertex: u32,
    first_direction: u32,
    substeps: u32,
    // Of one part of a step.
    dt: f32,
    stiffness: f32,
    gravity: vec3f,
    elasticity: f32,
    damping: f32,
    grain: f32,
    // Bumps to a metre.
    grain_frequency: f32,
    seed: u32,
    // Where it stays.
    keep_low: vec3f,
    // How hard an upright surface draws what lies on it down.
    downhill: f32,
    keep_high: vec3f,
}

// How the far end of a volume's axis has run.
struct Run {
    offset: vec3f,
    velocity: vec3f,
}

@group(0) @binding(0) var<uniform> group: Group;
@group(0) @binding(1) var<storage, read> orders: array<Order>;
@group(0) @binding(2) var<storage, read> directions: array<vec4f>;
// Radius and speed.
@group(0) @binding(3) var<storage, read_write> vertices: array<vec2f>;
@group(0) @binding(4) var<storage, read_write> runs: array<Run>;
@group(0) @binding(5) var<storage, read_write> bodies: array<Body>;
@group(0) @binding(6) var<uniform> ground: Ground;
@group(0) @binding(7) var<storage, read> ground_cells: array<u32>;
@group(0) @binding(8) var<storage, read> ground_corners: array<vec4f>;

// How far the ground lets paint go at a place: about -1 to 1.
fn grain_at(place: vec3f) -> f32 {
    var sum = 0.0;
    var p = place * group.grain_frequency;
    for (var octave = 0u; octave < 3u; octave++) {
        sum += noise(p, group.seed + octave).w / f32(1u << octave);
        p *= 2.0;
    }
    // Noise hardly ever comes near its bounds.
    return clamp(0.7 * sum, -1.0, 1.0);
}

// How the surface draws a vertex, along its ray.
fn downhill_at(volume: u32, order: Order, direction: vec3f, radius: f32) -> f32 {
    if group.downhill == 0.0 {
        return 0.0;
    }
    let body = bodies[group.first_body + volume];
    let is_far = order.state != COMES && dot(body.end - order.start, direction) > 0.0;
    let place = select(order.start, body.end, is_far) + direction * radius;
    return group.downhill * dot(drawn_at(place, order.desired, group.gravity), direction);
}

@compute @workgroup_size(256)
fn spread(@builtin(workgroup_id) id: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = (id.y * groups.x + id.x) * 256u + lane;
    if index >= group.volumes * group.vertices {
        return;
    }
    let slot = group.first_vertex + index;
    let order = orders[index / group.vertices];
    if order.state == 0u {
        vertices[slot] = vec2f(0.0);
        return;
    }
    let direction = directions[group.first_direction + index % group.vertices].xyz;
    let wanted = order.desired * (1.0 + group.grain * grain_at(order.start + direction * order.desired));
    var radius = vertices[slot].x;
    var speed = vertices[slot].y;
    if order.state == COMES {
        radius = order.first;
        speed = 0.0;
    }
    let pull = dot(group.gravity, direction)
        + downhill_at(index / group.vertices, order, direction, radius);
    for (var part = 0u; part < group.substeps; part++) {
        let force = group.stiffness * (wanted - radius) + group.elasticity * (order.first - radius) + pull;
        speed += group.dt * (force - group.damping * speed);
        radius += group.dt * speed;
        // What is pulled through the axis rests on it.
        speed = select(speed, 0.0, radius <= 0.0);
        radius = max(radius, 0.0);
    }
    vertices[slot] = vec2f(radius, speed);
}

@compute @workgroup_size(256)
fn run(@builtin(workgroup_id) id: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = (id.y * groups.x + id.x) * 256u + lane;
    if index >= group.volumes {
        return;
    }
    let slot = group.first_body + index;
    let order = orders[index];
    var run = runs[slot];
    if order.state <= COMES {
        run = Run(vec3f(0.0), vec3f(0.0));
    }
    if order.state != 0u {
        let before = order.end + run.offset;
        var pull = group.gravity;
        if group.downhill > 0.0 {
            pull += group.downhill * drawn_at(before, order.desired, group.gravity);
        }
        for (var part = 0u; part < group.substeps; part++) {
            let force = pull - group.elasticity * run.offset;
            run.velocity += group.dt * (force - group.damping * run.velocity);
            run.offset += group.dt * run.velocity;
        }
        if group.downhill > 0.0 {
            run.offset = slid(before, order.end + run.offset - before, order.desired) - order.end;
        }
    }
    runs[slot] = run;
    bodies[slot].start = order.start;
    bodies[slot].end = clamp(order.end + run.offset, group.keep_low, group.keep_high);
}
