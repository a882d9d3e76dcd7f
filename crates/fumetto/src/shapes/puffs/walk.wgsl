// Walking the lists of the tiles that show anything: each invocation has a block of 4 x 4 pixels.

@group(0) @binding(1) var<uniform> bins: Bins;
@group(0) @binding(2) var<storage, read> summary: Summary;
@group(0) @binding(3) var<storage, read> tiles: array<vec2u>;
@group(0) @binding(4) var<storage, read> covered: array<u32>;
@group(0) @binding(5) var entries: texture_storage_2d<rg32uint, read>;
@group(0) @binding(6) var projected: texture_storage_2d<rgba32uint, read>;
@group(0) @binding(7) var heights: texture_storage_2d<rg32uint, read>;
@group(0) @binding(8) var found: texture_storage_2d<rgba32uint, write>;

fn slot_of(group: vec3u, groups: vec3u, lane: u32) -> u32 {
    return (group.y * groups.x + group.x) * WALK_TILES + lane / 16u;
}

// The first pixel of an invocation's block.
fn block_px(slot: u32, lane: u32) -> vec2u {
    return vec2u(covered[slot] & 0xffffu, covered[slot] >> 16u) * TILE_PX + 4u * pixel_of(lane % 16u);
}

fn pixel_of(index: u32) -> vec2u {
    return vec2u(index % 4u, index / 4u);
}

// The pixels of a row of a block.
const ACROSS: vec4u = vec4u(0u, 1u, 2u, 3u);

// How far each pixel sees, row by row.
var<private> distances: array<vec4f, 4>;

// How far anything sees in each row, as it was measured last.
var<private> rows: vec4f;

fn farthest_of(four: vec4f) -> f32 {
    return max(max(four.x, four.y), max(four.z, four.w));
}

fn measure_rows() {
    rows = vec4f(
        farthest_of(distances[0]),
        farthest_of(distances[1]),
        farthest_of(distances[2]),
        farthest_of(distances[3]),
    );
}

// Whether any row comes within a circle around a middle and sees as far as `distance`; the first pixel is `offset`
// from the middle.
fn reaches(offset: vec2f, reach_px2: f32, distance: f32) -> bool {
    // Of the pixel that is nearest to the middle.
    let across = max(max(offset.x, -3.0 - offset.x), 0.0);
    let down = offset.y + vec4f(ACROSS);
    return any((across * across + down * down <= vec4f(reach_px2)) & (rows >= vec4f(distance)));
}

// What is read of buffers, once and in no loop: software rasterisers do that for one invocation after another.
var<private> near: f32;
var<private> focal_px: f32;
// What is added to the logarithm of a distance, and what that is then multiplied by, to make a rank.
var<private> rank_scale: vec2f;

fn begin_walk() {
    near = view.near;
    focal_px = view.focal_px;
    let nearest = bitcast<f32>(summary.nearest);
    let octaves = log2(nearest / bitcast<f32>(~summary.farthest));
    rank_scale = vec2f(log2(nearest / near), 65535.0 / max(octaves, 1e-4));
}

// Rank beyond which nothing is nearer than that; a little more, for logarithms are not exact.
fn rank_limit(far: f32) -> u32 {
    let rank = (log2(max(far, near)) + rank_scale.x) * rank_scale.y;
    return u32(clamp(rank + 8.0, 0.0, 65535.0));
}

// A block's list of one level.
struct List {
    next: u32,
    end: u32,
    // Of the block, in an entry.
    bit: u32,
}

fn list_of(level: u32, px: vec2u) -> List {
    let bounds = tiles[level_tile(level, px)];
    let block = (px >> vec2u(level + 2u)) & vec2u(3u);
    return List(bounds.x, bounds.y, 1u << (block.y * 4u + block.x));
}

// The next puff + 1 that may touch the block and is not beyond `rank`; 0 when there is none.
fn next_of(list: ptr<function, List>, rank: u32) -> u32 {
    loop {
        if (*list).next >= (*list).end {
            break;
        }
        let entry = textureLoad(entries, entry_at((*list).next)).xy;
        let is_last = slice_of(entry.y >> 16u) > slice_of(rank);
        (*list).next = select((*list).next + 1u, (*list).end, is_last);
        if (entry.y & (*list).bit) != 0u && (entry.y >> 16u) <= rank {
            return entry.x + 1u;
        }
    }
    return 0u;
}
