// Air in obstacles moves as they do. Done before pressure is asked for and after, step by step, the air finds its way
// round them (alternating projections; cf. Angot, Bruneau & Fabrie 1999, who penalise what moves in them).

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read_write> u: array<f32>;
@group(0) @binding(2) var<storage, read_write> v: array<f32>;
@group(0) @binding(3) var<storage, read_write> w: array<f32>;
@group(0) @binding(4) var<storage, read> solid: array<vec2u>;

// `air` on face `f` across `axis`, as far as it is free.
fn held(f: vec3u, facing: vec3u, axis: u32, air: f32) -> f32 {
    let behind = solid_at(max(f, facing) - facing);
    let ahead = solid_at(min(f, grid.cells - 1u));
    let share = clamp(0.5 - 0.5 * (behind.w + ahead.w), 0.0, 1.0);
    return mix(air, 0.5 * (behind[axis] + ahead[axis]), share);
}

@compute @workgroup_size(32, 4, 2)
fn main(@builtin(global_invocation_id) f: vec3u) {
    let at = face_index(f);
    let inside = f < grid.cells;
    if f.x <= grid.cells.x && inside.y && inside.z {
        u[at] = held(f, vec3u(1u, 0u, 0u), 0u, u[at]);
    }
    if f.y <= grid.cells.y && inside.x && inside.z {
        v[at] = held(f, vec3u(0u, 1u, 0u), 1u, v[at]);
    }
    if f.z <= grid.cells.z && inside.x && inside.y {
        w[at] = held(f, vec3u(0u, 0u, 1u), 2u, w[at]);
    }
}
