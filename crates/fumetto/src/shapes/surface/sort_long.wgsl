// Sorts the lists that are too long for `sort.wgsl`: a workgroup sorts one. Bitonic, in the form in which all comparisons point the same way (Batcher 1968), so that
// lists may have any length: what would lie beyond the end never moves.

@group(0) @binding(0) var<storage, read> lattice: Lattice;
@group(0) @binding(1) var<storage, read> starts: array<u32>;
@group(0) @binding(2) var<storage, read> active_blocks: array<ActiveBlock>;
@group(0) @binding(3) var<storage, read> vertex_counts: array<u32>;
@group(0) @binding(4) var<storage, read_write> entries: array<u32>;

// Longer lists only, as in `sort.wgsl`.
const SHORT: u32 = 128u;

// The lower place of the `pair`-th two that lie `gap` apart.
fn low_of(pair: u32, gap: u32) -> u32 {
    return pair + pair / gap * gap;
}

fn order(first: u32, low: u32, high: u32, length: u32) {
    if high < length {
        let a = entries[first + low];
        let b = entries[first + high];
        if a > b {
            entries[first + low] = b;
            entries[first + high] = a;
        }
    }
}

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = group.y * groups.x + group.x;
    if slot >= lattice.active_blocks || vertex_counts[slot] == 0u {
        return;
    }
    let block = active_blocks[slot].number;
    let first = starts[block];
    let length = starts[block + 1u] - first;
    if length <= SHORT {
        return;
    }
    for (var half = 1u; half < length; half *= 2u) {
        // Two sorted stretches of `half` each: the second is compared from its end.
        for (var pair = lane; low_of(pair, half) < length; pair += 64u) {
            let low = low_of(pair, half);
            order(first, low, low ^ (2u * half - 1u), length);
        }
        storageBarrier();
        for (var gap = half / 2u; gap > 0u; gap /= 2u) {
            for (var pair = lane; low_of(pair, gap) < length; pair += 64u) {
                order(first, low_of(pair, gap), low_of(pair, gap) + gap, length);
            }
            storageBarrier();
        }
    }
}
