// How much more air would flow out of every cell than into it.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read> u: array<f32>;
@group(0) @binding(2) var<storage, read> v: array<f32>;
@group(0) @binding(3) var<storage, read> w: array<f32>;
@group(0) @binding(4) var<storage, read_write> push: array<vec2u>;
@group(0) @binding(5) var<storage, read_write> wanted: array<f32>;

@compute @workgroup_size(32, 4, 2)
fn main(@builtin(global_invocation_id) c: vec3u) {
    if any(c >= grid.cells) {
        return;
    }
    let stride = face_stride();
    let at = face_index(c);
    let at_low = c == vec3u(0u);
    let at_high = c + 1u == grid.cells;
    let own = push_at(c);
    let low = max(c, vec3u(1u)) - 1u;
    let high = min(c + 1u, grid.cells - 1u);
    let before = vec3f(push_at(vec3u(low.x, c.yz)).x, push_at(vec3u(c.x, low.y, c.z)).y, push_at(vec3u(c.xy, low.z)).z);
    let after = vec3f(push_at(vec3u(high.x, c.yz)).x, push_at(vec3u(c.x, high.y, c.z)).y, push_at(vec3u(c.xy, high.z)).z);
    let enters = vec3f(u[at], v[at], w[at]) + pushed(own.xyz, before, at_low, 0u);
    let leaves = vec3f(u[at + 1u], v[at + stride.y], w[at + stride.z]) + pushed(own.xyz, after, at_high, 1u);
    let more = leaves - enters;
    wanted[cell_index(c)] = more.x + more.y + more.z - own.w * grid.side;
}
