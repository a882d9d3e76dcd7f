// Tells how many pieces of lines there are; those that there is no room for are left out.

@group(0) @binding(0) var<storage, read> draw: array<u32>;
@group(0) @binding(1) var<storage, read_write> tally: Tally;
@group(0) @binding(2) var<storage, read> records: array<Record>;

@compute @workgroup_size(1)
fn main() {
    tally = tally_of(min(draw[5], arrayLength(&records)));
}
