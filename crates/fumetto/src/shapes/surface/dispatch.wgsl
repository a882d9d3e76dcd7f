// Writes how many workgroups the kernel gets that takes thirty-two active blocks each.

@group(0) @binding(0) var<storage, read> lattice: Lattice;
@group(0) @binding(1) var<storage, read_write> groups: array<u32, 3>;

@compute @workgroup_size(1)
fn main() {
    groups = folded((lattice.active_blocks + 31u) / 32u);
}
