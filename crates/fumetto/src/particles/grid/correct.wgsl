// The second pass, where there is smoke: MacCormack's scheme with a limiter (Selle, Fedkiw, Kim, Liu & Rossignac
// 2008). The guess is traced forth again, and half of what that missed by is made good.

@group(0) @binding(6) var<storage, read_write> fixed: array<f32>;
@group(0) @binding(7) var<storage, read> busy: array<u32>;

@compute @workgroup_size(256)
fn find(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    for (var half = 0u; half < 2u; half++) {
        let f = cell_of(busy[BUSY + group.x], lane, half);
        fixed[face_index(f)] = better(f);
    }
}

@compute @workgroup_size(256)
fn keep(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    for (var half = 0u; half < 2u; half++) {
        let at = face_index(cell_of(busy[BUSY + group.x], lane, half));
        carried[at] = fixed[at];
    }
}

fn better(f: vec3u) -> f32 {
    let shift = shift_at(f);
    let stride = face_stride();
    let at = face_index(f);
    let p = vec3f(f) - shift;
    let i = around_face(p).first;
    let j = i + stride.z;
    let low = vec4f(field[i], field[i + 1u], field[i + stride.y], field[i + stride.y + 1u]);
    let high = vec4f(field[j], field[j + 1u], field[j + stride.y], field[j + stride.y + 1u]);
    let b = around_face(vec3f(f) + shift);
    let k = b.first;
    let l = k + stride.z;
    let near = vec4f(carried[k], carried[k + 1u], carried[k + stride.y], carried[k + stride.y + 1u]);
    let far = vec4f(carried[l], carried[l + 1u], carried[l + stride.y], carried[l + stride.y + 1u]);
    let guess = carried[at];
    let least = min(low, high);
    let most = max(low, high);
    let limited = clamp(
        guess - grid.gust[AXIS] + 0.5 * (field[at] - blend(near, far, b.share) + grid.gust[AXIS]),
        min(min(least.x, least.y), min(least.z, least.w)),
        max(max(most.x, most.y), max(most.z, most.w)),
    );
    return select(limited + grid.gust[AXIS], guess, is_beyond(p) || is_wall(f));
}
