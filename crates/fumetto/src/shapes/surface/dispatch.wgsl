// Writes how many workgroups the kernels get that take eight active blocks each.

@group(0) @binding(0) var<storage, read> lattice: Lattice;
@group(0) @binding(1) var<storage, read_write> groups: array<u32, 3>;
// For `sort_long.wgsl`: none, unless a long list is met.
@group(0) @binding(2) var<storage, read_write> long: array<u32, 3>;

@compute @workgroup_size(1)
fn main() {
    let eights = (lattice.active_blocks + 7u) / 8u;
    // Rows, where there are more than one axis may have.
    let rows = max((eights + 65534u) / 65535u, 1u);
    groups = array((eights + rows - 1u) / rows, rows, 1u);
    long = array(0u, 1u, 1u);
}
