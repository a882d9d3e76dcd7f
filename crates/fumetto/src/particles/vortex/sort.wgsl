// Sorts keys; no two are alike, so there is one right order. Bitonic, in the form in which all comparisons
// point the same way (Batcher 1968): stretches of 2048 in a workgroup's own memory, and what is farther apart
// one pass for each distance.

struct Sort {
    // Sorted stretches of this many become twice as long.
    half: u32,
    // Distance of what is compared.
    gap: u32,
}

@group(0) @binding(0) var<uniform> sort: Sort;
@group(0) @binding(1) var<storage, read_write> keys: array<vec2u>;

const CHUNK: u32 = 2048u;

var<workgroup> chunk: array<vec2u, CHUNK>;

fn is_after(a: vec2u, b: vec2u) -> bool {
    return a.x > b.x || (a.x == b.x && a.y > b.y);
}

// The lower place of the `pair`-th two that lie `gap` apart.
fn low_of(pair: u32, gap: u32) -> u32 {
    return pair + pair / gap * gap;
}

fn order_in_chunk(low: u32, high: u32) {
    let a = chunk[low];
    let b = chunk[high];
    if is_after(a, b) {
        chunk[low] = b;
        chunk[high] = a;
    }
}

fn take(group: u32, lane: u32) {
    for (var place = lane; place < CHUNK; place += 256u) {
        chunk[place] = keys[group * CHUNK + place];
    }
    workgroupBarrier();
}

fn give(group: u32, lane: u32) {
    for (var place = lane; place < CHUNK; place += 256u) {
        keys[group * CHUNK + place] = chunk[place];
    }
}

// Brings what lies `widest` apart and nearer into order.
fn settle(widest: u32, lane: u32) {
    for (var gap = widest; gap > 0u; gap /= 2u) {
        for (var pair = lane; pair < CHUNK / 2u; pair += 256u) {
            order_in_chunk(low_of(pair, gap), low_of(pair, gap) + gap);
        }
        workgroupBarrier();
    }
}

@compute @workgroup_size(256)
fn sort_chunks(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    take(group.x, lane);
    for (var half = 1u; half < CHUNK; half *= 2u) {
        // Two sorted stretches of `half` each: the second is compared from its end.
        for (var pair = lane; pair < CHUNK / 2u; pair += 256u) {
            let low = low_of(pair, half);
            order_in_chunk(low, low ^ (2u * half - 1u));
        }
        workgroupBarrier();
        settle(half / 2u, lane);
    }
    give(group.x, lane);
}

// One comparison of a merge of stretches that are longer than a chunk.
@compute @workgroup_size(256)
fn compare(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let low = low_of(group.x * 256u + lane, sort.gap);
    let high = select(low + sort.gap, low ^ (2u * sort.half - 1u), sort.gap == sort.half);
    let a = keys[low];
    let b = keys[high];
    if is_after(a, b) {
        keys[low] = b;
        keys[high] = a;
    }
}

// The rest of such a merge.
@compute @workgroup_size(256)
fn settle_chunks(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    take(group.x, lane);
    settle(CHUNK / 2u, lane);
    give(group.x, lane);
}
