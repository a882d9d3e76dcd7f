// Half a sweep of red-black Gauss-Seidel: cells of one colour have neighbours of the other colour only, so that
// their order does not matter.

@compute @workgroup_size(32, 4, 2)
fn main(@builtin(global_invocation_id) item: vec3u) {
    let c = coloured(item);
    if any(c >= level.cells) {
        return;
    }
    let at = level.first + index_in(level.cells, c);
    let around = neighbours(at, c);
    pressure[at] = (around.x - wanted[at]) / around.y;
}
