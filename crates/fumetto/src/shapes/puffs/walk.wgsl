// Walking the lists of the tiles that show anything: each invocation has a block of 4 x 4 pixels.

@group(0) @binding(1) var<uniform> bins: Bins;
@group(0) @binding(2) var<storage, read> summary: Summary;
@group(0) @binding(3) var<storage, read> tiles: array<vec2u>;
@group(0) @binding(4) var<storage, read> covered: array<u32>;
// The second is how many are covered.
@group(0) @binding(5) var<storage, read> draw: array<u32, 4>;
@group(0) @binding(6) var entries: texture_storage_2d<rg32uint, read>;
@group(0) @binding(7) var projected: texture_storage_2d<rgba32uint, read>;
@group(0) @binding(8) var heights: texture_storage_2d<rg32uint, read>;
@group(0) @binding(9) var found: texture_storage_2d<rgba32uint, write>;

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

// How far each pixel sees.
var<private> distances: array<f32, 16>;

fn farthest() -> f32 {
    var far = distances[0];
    for (var pixel = 1u; pixel < 16u; pixel++) {
        far = max(far, distances[pixel]);
    }
    return far;
}

// Rank beyond which nothing is nearer than that; a little more, for logarithms are not exact.
fn rank_limit(far: f32) -> u32 {
    return min(u32(rank_of(depth_of(far), summary)) + 8u, 65535u);
}

// A block's list of one level.
struct List {
    next: u32,
    end: u32,
    // Of the block, in an entry.
    bit: u32,
}

fn list_of(level: u32, px: vec2u) -> List {
    let bounds = tiles[level_tile(bins, level, px)];
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
