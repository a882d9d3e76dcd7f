// Heat and smoke, carried by the velocity in two steps as that is itself (see `guess.wgsl` and `correct.wgsl`), but for
// what is out of range: velocity is clamped, these stay as guessed. `feed.wgsl` then fades them and brings new ones.
// Where nothing is busy there is neither.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read> u: array<f32>;
@group(0) @binding(2) var<storage, read> v: array<f32>;
@group(0) @binding(3) var<storage, read> w: array<f32>;
@group(0) @binding(4) var<storage, read> field: array<vec2f>;
@group(0) @binding(5) var<storage, read_write> carried: array<vec2f>;
@group(0) @binding(6) var<storage, read_write> fixed: array<vec2f>;
@group(0) @binding(7) var<storage, read> busy: array<u32>;

// Cells that the air in the middle of a cell moves by.
fn shift_at(c: vec3u) -> vec3f {
    let stride = face_stride();
    let at = face_index(c);
    let low = vec3f(u[at], v[at], w[at]);
    let high = vec3f(u[at + 1u], v[at + stride.y], w[at + stride.z]);
    return (low + high) * (0.5 * grid.dt / grid.side);
}

fn cell_stride() -> vec3u {
    return vec3u(1u, grid.cells.x, grid.cells.x * grid.cells.y);
}

fn blend_two(values: array<vec2f, 8>, share: vec3f) -> vec2f {
    let low = mix(mix(values[0], values[1], share.x), mix(values[2], values[3], share.x), share.y);
    let high = mix(mix(values[4], values[5], share.x), mix(values[6], values[7], share.x), share.y);
    return mix(low, high, share.z);
}

fn fields_around(i: u32) -> array<vec2f, 8> {
    let s = cell_stride();
    let j = i + s.z;
    return array(
        field[i], field[i + 1u], field[i + s.y], field[i + s.y + 1u],
        field[j], field[j + 1u], field[j + s.y], field[j + s.y + 1u],
    );
}

fn carried_around(i: u32) -> array<vec2f, 8> {
    let s = cell_stride();
    let j = i + s.z;
    return array(
        carried[i], carried[i + 1u], carried[i + s.y], carried[i + s.y + 1u],
        carried[j], carried[j + 1u], carried[j + s.y], carried[j + s.y + 1u],
    );
}

@compute @workgroup_size(256)
fn guess(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    for (var half = 0u; half < 2u; half++) {
        let c = cell_of(busy[BUSY + group.x], lane, half);
        let p = vec3f(c) - shift_at(c);
        let a = around(p, grid.cells - 1u, cell_stride());
        let inside = blend_two(fields_around(a.first), a.share);
        carried[cell_index(c)] = select(inside, vec2f(0.0), is_outside(p + 0.5));
    }
}

@compute @workgroup_size(256)
fn correct(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    for (var half = 0u; half < 2u; half++) {
        let c = cell_of(busy[BUSY + group.x], lane, half);
        fixed[cell_index(c)] = better(c);
    }
}

fn better(c: vec3u) -> vec2f {
    let at = cell_index(c);
    let shift = shift_at(c);
    let p = vec3f(c) - shift;
    let known = fields_around(around(p, grid.cells - 1u, cell_stride()).first);
    let b = around(vec3f(c) + shift, grid.cells - 1u, cell_stride());
    let exact = carried[at] + 0.5 * (field[at] - blend_two(carried_around(b.first), b.share));
    var least = known[0];
    var most = known[0];
    for (var i = 1u; i < 8u; i++) {
        least = min(least, known[i]);
        most = max(most, known[i]);
    }
    // What would be out of range stays as guessed: clamped to the range, a jet's smoke grew by a third in sixty steps.
    let is_safe = (exact >= least) & (exact <= most);
    return select(select(carried[at], exact, is_safe), vec2f(0.0), is_outside(p + 0.5));
}
