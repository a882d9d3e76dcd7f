// Pushes the air, and takes the slope of the pressure from its velocity.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read_write> u: array<f32>;
@group(0) @binding(2) var<storage, read_write> v: array<f32>;
@group(0) @binding(3) var<storage, read_write> w: array<f32>;
@group(0) @binding(4) var<storage, read_write> push: array<vec2u>;
@group(0) @binding(5) var<storage, read> pressure: array<f32>;

// The change of the component along `axis` on face `f`: between two cells, or at a wall.
fn change(f: vec3u, axis: u32, facing: vec3u) -> f32 {
    if f[axis] > 0u && f[axis] < grid.cells[axis] {
        let before = f - facing;
        let gain = 0.5 * grid.dt * (push_at(f)[axis] + push_at(before)[axis]);
        return gain - (pressure[cell_index(f)] - pressure[cell_index(before)]);
    }
    let end = u32(f[axis] > 0u);
    if !is_open(axis, end) {
        return 0.0;
    }
    // Pressure is zero on the open wall itself, half a cell away.
    let cell = f - end * facing;
    let slope = 2.0 * pressure[cell_index(cell)];
    return grid.dt * push_at(cell)[axis] + select(-slope, slope, end == 1u);
}

@compute @workgroup_size(32, 4, 2)
fn main(@builtin(global_invocation_id) f: vec3u) {
    let at = face_index(f);
    let inside = f < grid.cells;
    if f.x <= grid.cells.x && inside.y && inside.z {
        u[at] += change(f, 0u, vec3u(1u, 0u, 0u));
    }
    if f.y <= grid.cells.y && inside.x && inside.z {
        v[at] += change(f, 1u, vec3u(0u, 1u, 0u));
    }
    if f.z <= grid.cells.z && inside.x && inside.y {
        w[at] += change(f, 2u, vec3u(0u, 0u, 1u));
    }
}
