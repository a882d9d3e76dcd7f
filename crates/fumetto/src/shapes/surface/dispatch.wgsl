// Writes how many workgroups the kernels get that run over active blocks.

@group(0) @binding(0) var<storage, read> lattice: Lattice;
@group(0) @binding(1) var<storage, read_write> groups: array<u32, 3>;

@compute @workgroup_size(1)
fn main() {
    // Rows, where there are more than one axis may have.
    let rows = (lattice.active_blocks + 65534u) / 65535u;
    groups = array((lattice.active_blocks + max(rows, 1u) - 1u) / max(rows, 1u), rows, 1u);
}
