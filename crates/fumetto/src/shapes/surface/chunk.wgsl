// Blocks in chunks: eight of a block's vertices, and as large a share of its cells. Chunks are alike, blocks are not.

const IN_CHUNK: u32 = 8u;

struct Chunk {
    // The block's.
    slot: u32,
    // Which of its chunks.
    index: u32,
    // How many it has.
    count: u32,
    // Numbers of its first vertex and triangle.
    first_vertex: u32,
    first_triangle: u32,
}

// A block may have triangles and no vertices: these are its neighbours'.
fn chunks_of(vertices: u32, triangles: u32) -> u32 {
    return max((vertices + IN_CHUNK - 1u) / IN_CHUNK, min(triangles, 1u));
}
