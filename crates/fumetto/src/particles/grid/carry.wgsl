// One component of the velocity, carried along by the velocity: what both passes need.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read> u: array<f32>;
@group(0) @binding(2) var<storage, read> v: array<f32>;
@group(0) @binding(3) var<storage, read> w: array<f32>;
// The one of these that is carried.
@group(0) @binding(4) var<storage, read> field: array<f32>;
// It, carried: at first a guess.
@group(0) @binding(5) var<storage, read_write> carried: array<f32>;

// Cells that the air in the middle of a face moves by.
fn shift_at(f: vec3u) -> vec3f {
    let stride = face_stride();
    let step = dot(FACING, stride);
    let at = face_index(f);
    // The cells on both sides; at a wall the only one, twice.
    let before = at - select(0u, step, f[AXIS] > 0u);
    let after = at - select(0u, step, f[AXIS] == grid.cells[AXIS]);
    var sum = vec3f(field[at] * 4.0);
    if AXIS != 0u {
        sum.x = u[before] + u[before + 1u] + u[after] + u[after + 1u];
    }
    if AXIS != 1u {
        sum.y = v[before] + v[before + stride.y] + v[after] + v[after + stride.y];
    }
    if AXIS != 2u {
        sum.z = w[before] + w[before + stride.z] + w[after] + w[after + stride.z];
    }
    return sum * (0.25 * grid.dt / grid.side);
}

fn around_face(p: vec3f) -> Around {
    return around(p, grid.cells - 1u + FACING, face_stride());
}

fn is_face(f: vec3u) -> bool {
    return all(f < grid.cells + FACING);
}

fn is_beyond(p: vec3f) -> bool {
    return is_outside(p + 0.5 * vec3f(1u - FACING));
}

fn is_wall(f: vec3u) -> bool {
    return (f[AXIS] == 0u && !is_open(AXIS, 0u)) || (f[AXIS] == grid.cells[AXIS] && !is_open(AXIS, 1u));
}
