// The chunk of a number that is less than how many there are: searches for its block.
fn chunk_at(number: u32, blocks: u32) -> Chunk {
    var slot = 0u;
    var end = blocks;
    while end - slot > 1u {
        let middle = (slot + end) / 2u;
        if mesh_starts[middle].z <= number {
            slot = middle;
        } else {
            end = middle;
        }
    }
    let start = mesh_starts[slot];
    return Chunk(slot, number - start.z, mesh_starts[slot + 1u].z - start.z, start.x, start.y);
}
