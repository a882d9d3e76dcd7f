// Vorticity confinement (Fedkiw, Stam & Jensen 2001): turns the air about where it turns most.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read> spin: array<vec2u>;
@group(0) @binding(2) var<storage, read_write> push: array<vec2u>;
@group(0) @binding(3) var<storage, read> busy: array<u32>;

fn spin_at(at: u32) -> f32 {
    return unpack2x16float(spin[at].y).y;
}

fn confined(c: vec3u) -> vec3f {
    let at = cell_index(c);
    let stride = vec3u(1u, grid.cells.x, grid.cells.x * grid.cells.y);
    let low = at - select(vec3u(0u), stride, c > vec3u(0u));
    let high = at + select(vec3u(0u), stride, c + 1u < grid.cells);
    let slope = vec3f(
        spin_at(high.x) - spin_at(low.x),
        spin_at(high.y) - spin_at(low.y),
        spin_at(high.z) - spin_at(low.z),
    );
    let own = vec3f(unpack2x16float(spin[at].x), unpack2x16float(spin[at].y).x);
    return grid.confinement * grid.side * cross(slope / max(length(slope), 1e-6), own);
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    for (var half = 0u; half < 2u; half++) {
        let c = cell_of(busy[BUSY + group.x], lane, half);
        add_push(c, confined(c));
    }
}
