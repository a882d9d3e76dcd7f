// What accelerates the air in every busy cell: forces, heat and emitters.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read> u: array<f32>;
@group(0) @binding(2) var<storage, read> v: array<f32>;
@group(0) @binding(3) var<storage, read> w: array<f32>;
@group(0) @binding(4) var<storage, read> heat: array<vec2f>;
@group(0) @binding(5) var<storage, read> forces: array<Force>;
@group(0) @binding(6) var<storage, read> sources: array<Source>;
@group(0) @binding(7) var<storage, read_write> push: array<vec2u>;
@group(0) @binding(8) var<storage, read> busy: array<u32>;

fn velocity_in(at: u32) -> vec3f {
    let stride = face_stride();
    return 0.5 * (vec3f(u[at], v[at], w[at]) + vec3f(u[at + 1u], v[at + stride.y], w[at + stride.z]));
}

// The Laplacian of the velocity.
fn spread(c: vec3u, own: vec3f) -> vec3f {
    let at = face_index(c);
    let stride = face_stride();
    let low = at - select(vec3u(0u), stride, c > vec3u(0u));
    let high = at + select(vec3u(0u), stride, c + 1u < grid.cells);
    let sum = velocity_in(low.x) + velocity_in(high.x) + velocity_in(low.y) + velocity_in(high.y)
        + velocity_in(low.z) + velocity_in(high.z);
    return (sum - 6.0 * own) / (grid.side * grid.side);
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    for (var half = 0u; half < 2u; half++) {
        let c = cell_of(busy[BUSY + group.x], lane, half);
        set_push(c, pushes(c));
    }
}

fn pushes(c: vec3u) -> vec4f {
    let p = grid.origin + (vec3f(c) + 0.5) * grid.side;
    let velocity = velocity_in(face_index(c));
    let here = heat[cell_index(c)];
    let air = air_at(p, 0.0, grid.forces);
    // Forces that push smoke push the air that it is in.
    var sum = here.y * air.acceleration + vec3f(0.0, grid.lift * here.x, 0.0);
    // Exact for air that is dragged by nothing else.
    sum += (air.velocity - velocity) * ((1.0 - exp(-air.drag * grid.dt)) / grid.dt);
    var appears = 0.0;
    for (var i = 0u; i < grid.sources; i++) {
        let source = sources[i];
        let share = share_of(source, p);
        if source.drives == 1u {
            sum += (share / grid.dt) * (source.velocity - velocity);
        }
        appears += share * source.expansion;
    }
    if grid.viscosity > 0.0 {
        sum += grid.viscosity * spread(c, velocity);
    }
    return vec4f(sum, appears);
}
