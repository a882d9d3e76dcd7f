// Workgroups of an indirect dispatch: in rows, where there are more than one axis may have.
fn folded(count: u32) -> array<u32, 3> {
    let rows = max((count + 65534u) / 65535u, 1u);
    return array((count + rows - 1u) / rows, rows, 1u);
}
