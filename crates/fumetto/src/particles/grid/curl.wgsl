// Vorticity in the middle of every busy cell.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read> u: array<f32>;
@group(0) @binding(2) var<storage, read> v: array<f32>;
@group(0) @binding(3) var<storage, read> w: array<f32>;
// Half floats: x, y, z and the length; per second.
@group(0) @binding(4) var<storage, read_write> spin: array<vec2u>;
@group(0) @binding(5) var<storage, read> busy: array<u32>;

// Half floats end here.
const MOST: f32 = 6e4;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    for (var half = 0u; half < 2u; half++) {
        let c = cell_of(busy[BUSY + group.x], lane, half);
        spin[cell_index(c)] = vorticity_in(c);
    }
}

fn vorticity_in(c: vec3u) -> vec2u {
    let stride = face_stride();
    let at = face_index(c);
    // Neighbours; at a wall the cell itself.
    let low = at - select(vec3u(0u), stride, c > vec3u(0u));
    let high = at + select(vec3u(0u), stride, c + 1u < grid.cells);
    // Twice the mean of two faces is the velocity in a cell's middle, and neighbours lie two sides apart.
    let across_x = vec2f(v[high.x] + v[high.x + stride.y] - v[low.x] - v[low.x + stride.y],
        w[high.x] + w[high.x + stride.z] - w[low.x] - w[low.x + stride.z]);
    let across_y = vec2f(u[high.y] + u[high.y + 1u] - u[low.y] - u[low.y + 1u],
        w[high.y] + w[high.y + stride.z] - w[low.y] - w[low.y + stride.z]);
    let across_z = vec2f(u[high.z] + u[high.z + 1u] - u[low.z] - u[low.z + 1u],
        v[high.z] + v[high.z + stride.y] - v[low.z] - v[low.z + stride.y]);
    let curl = vec3f(across_y.y - across_z.y, across_z.x - across_x.y, across_x.x - across_y.x);
    let vorticity = clamp(curl * (0.25 / grid.side), vec3f(-MOST), vec3f(MOST));
    let amount = min(length(vorticity), MOST);
    return vec2u(pack2x16float(vorticity.xy), pack2x16float(vec2f(vorticity.z, amount)));
}
