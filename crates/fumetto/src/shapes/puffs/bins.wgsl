// Puffs by where on the screen they are: each is listed in all tiles that it may touch, of the level where
// tiles are at least half as wide as it. So it is in nine lists at most, however large it is. A list goes from
// near to far, slice by slice; in a slice it has no order, and what is made of it must not depend on one.

// Width of a tile of level 0, in pixels. Also in `bins.rs`.
const TILE_PX: u32 = 16u;
// Slices of depth. Also in `bins.rs`.
const SLICES: u32 = 32u;
// Entries in a row of the texture that holds the lists. Also in `bins.rs`.
const ENTRY_ROW: u32 = 4096u;
// Tiles that a workgroup walks, and workgroups in a row of a dispatch.
const WALK_TILES: u32 = 4u;
const WALK_ROW: u32 = 1024u;
// Tiles that a workgroup of `cover` has: columns and rows. Also in `bins.rs`.
const COVER_TILES: vec2u = vec2u(32u, 8u);

struct Bins {
    // Of puffs.
    count: u32,
    levels: u32,
    // Of what is drawn.
    size_px: vec2f,
    // Per level: first tile, columns, rows.
    level: array<vec4u, 12>,
}

struct Summary {
    // Bit patterns of reverse-Z depths, the second inverted: a positive float orders as its bits do.
    nearest: u32,
    farthest: u32,
    // On all lists.
    entries: u32,
    // A bit for each level that has any.
    levels: u32,
    // Bits of the least distance from the nearest point of any puff back to its ink billboard, inverted.
    ink_behind: u32,
    // Tiles of level 0 that show anything.
    covered: u32,
}

// An entry is a puff's number; then its nearness, from 0 for what is nearest of all to 65535, and below that
// a bit for each of the 4 x 4 blocks of the tile that it may touch.
fn entry_at(index: u32) -> vec2u {
    return vec2u(index % ENTRY_ROW, index / ENTRY_ROW);
}

fn slice_of(rank: u32) -> u32 {
    return rank / (65536u / SLICES);
}

// A run of covered tiles side by side: the column and row of the first, and how many there are.
fn run_packed(first: vec2u, tiles: u32) -> u32 {
    return first.x | (first.y << 12u) | (tiles << 24u);
}

fn run_unpacked(run: u32) -> vec3u {
    return vec3u(run & 0xfffu, (run >> 12u) & 0xfffu, run >> 24u);
}

// How far a reverse-Z depth is, on a logarithmic scale over all puffs.
fn rank_of(depth: f32, summary: Summary) -> f32 {
    let nearest = bitcast<f32>(summary.nearest);
    let octaves = log2(nearest / bitcast<f32>(~summary.farthest));
    return clamp(log2(nearest / max(depth, 1e-30)) / max(octaves, 1e-4), 0.0, 1.0) * 65535.0;
}

// Uses `bins` of the program that it is part of.
fn level_tile(level: u32, px: vec2u) -> u32 {
    let grid = bins.level[level];
    let at = (px / TILE_PX) >> vec2u(level);
    return grid.x + at.y * grid.y + at.x;
}
