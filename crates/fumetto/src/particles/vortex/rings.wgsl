// Vortex rings are born at an emitter's mouth.

struct Rings {
    dt: f32,
    seed: u32,
    // The first of their vortices in the list; rings that there is room for; vortices in each.
    first: u32,
    capacity: u32,
    segments: u32,
    // Number of the first ring of this step, how many there are, and how many of those come at once.
    first_birth: u32,
    births: u32,
    burst: u32,
    circulation: f32,
    life: f32,
    radius: f32,
    // Radius of the line.
    core: f32,
    // How far from round, as a share of the radius.
    wobble: f32,
    // 3 box, 4 line: rings appear anywhere in it. Others have them in the middle.
    shape: u32,
    // Speed away from the axis.
    outward: f32,
    speed: f32,
    center: vec4f,
    // Sides, or the line from `center`.
    extent: vec4f,
    axis: vec4f,
}

@group(0) @binding(0) var<uniform> rings: Rings;
@group(0) @binding(1) var<storage, read_write> vortices: array<Vortex>;

fn ring_center(key: u32) -> vec3f {
    let u = vec3f(random(key, 0u), random(key, 1u), random(key, 2u));
    switch rings.shape {
        case 3u: { return rings.center.xyz + (u - 0.5) * rings.extent.xyz; }
        case 4u: { return rings.center.xyz + u.x * rings.extent.xyz; }
        default: { return rings.center.xyz; }
    }
}

// From -1 to 1 round the ring: waves of two, three and four crests, in which rings of air do break up
// (Widnall & Sullivan 1973).
fn wave(key: u32, angle: f32, k: u32) -> f32 {
    var sum = 0.0;
    for (var crests = 2u; crests <= 4u; crests++) {
        sum += cos(f32(crests) * angle + TAU * random(key, k + crests));
    }
    return sum / 3.0;
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= rings.capacity * rings.segments {
        return;
    }
    // The one ring of this step, if any, that falls into this place.
    let ring = item / rings.segments;
    let nth = (ring + rings.capacity - rings.first_birth % rings.capacity) % rings.capacity;
    if nth >= rings.births {
        return;
    }
    // A stream's rings are spread over the step, a burst's are not: how much of it is over at birth.
    let stream = f32(rings.births - rings.burst);
    let over = select((f32(nth - rings.burst) + 0.5) / stream, 0.0, nth < rings.burst);
    let key = pcg(rings.seed + pcg(rings.first_birth + nth));
    let angle = TAU * f32(item % rings.segments) / f32(rings.segments);
    let sides = across(rings.axis.xyz);
    // By the right hand about the axis, so that what is inside goes along it.
    let outward = sides * vec2f(cos(angle), sin(angle));
    let size = rings.radius * (1.0 + rings.wobble * wave(key, angle, 4u));
    let along = rings.radius * rings.wobble * wave(key, angle, 16u);
    let velocity = rings.speed * rings.axis.xyz + rings.outward * outward;
    let place = ring_center(key) + size * outward + along * rings.axis.xyz;
    let late = over * rings.dt;
    vortices[rings.first + item] = Vortex(
        place - velocity * late,
        -late,
        velocity,
        rings.life,
        rings.circulation,
        rings.core,
        TAU * rings.radius / f32(rings.segments),
        0u,
    );
}
