// Adds the coarser level's pressure to this one, trilinearly. Only to odd cells: the sweep that follows begins with
// the even ones, and needs nothing of what they were.

@compute @workgroup_size(32, 4, 2)
fn main(@builtin(global_invocation_id) item: vec3u) {
    let c = coloured(item);
    if any(c >= level.cells) {
        return;
    }
    let cells = level.cells / 2u;
    let stride = vec3u(1u, cells.x, cells.x * cells.y);
    let near = c / 2u;
    // The other neighbour is on the side to which the cell lies.
    let upper = (c & vec3u(1u)) == vec3u(1u);
    let is_wall = select(near == vec3u(0u), near + 1u == cells, upper);
    let bits = vec3u(level.open) >> (vec3u(0u, 2u, 4u) + vec3u(upper));
    let is_open = (bits & vec3u(1u)) == vec3u(1u);
    // Beyond a wall lies the cell itself again, beyond an open one its opposite.
    let far = select(vec3f(0.25), select(vec3f(0.0), vec3f(-0.25), is_open), is_wall);
    let own = select(vec3f(0.75), select(vec3f(1.0), vec3f(0.75), is_open), is_wall);
    let at = level.coarser + index_in(cells, near);
    let ahead = select(stride, vec3u(0u), is_wall);
    let x = select(at - ahead.x, at + ahead.x, upper.x);
    let y = select(0u - ahead.y, ahead.y, upper.y);
    let z = select(0u - ahead.z, ahead.z, upper.z);
    let low = vec4f(pressure[at], pressure[x], pressure[at + y], pressure[x + y]);
    let high = vec4f(pressure[at + z], pressure[x + z], pressure[at + y + z], pressure[x + y + z]);
    let layer = own.z * low + far.z * high;
    let row = own.y * layer.xy + far.y * layer.zw;
    pressure[level.first + index_in(level.cells, c)] += own.x * row.x + far.x * row.y;
}
