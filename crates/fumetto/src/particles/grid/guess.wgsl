// The first pass: every value comes from where the air was (Stam 1999).

@compute @workgroup_size(32, 4, 2)
fn main(@builtin(global_invocation_id) f: vec3u) {
    if !is_face(f) {
        return;
    }
    let p = vec3f(f) - shift_at(f);
    let a = around_face(p);
    let stride = face_stride();
    let i = a.first;
    let j = i + stride.z;
    let low = vec4f(field[i], field[i + 1u], field[i + stride.y], field[i + stride.y + 1u]);
    let high = vec4f(field[j], field[j + 1u], field[j + stride.y], field[j + stride.y + 1u]);
    let inside = blend(low, high, a.share) + grid.gust[AXIS];
    let blows = grid.begins == 1u || is_beyond(p);
    carried[face_index(f)] = select(select(inside, grid.outside[AXIS], blows), 0.0, is_wall(f));
}
