// Sorts the lists of blocks that have vertices by particle: scattering left them in any order, and a sum of floats
// depends on it. Eight invocations sort a list, a workgroup eight lists: each counts what comes before its
// items.

@group(0) @binding(0) var<storage, read> lattice: Lattice;
@group(0) @binding(1) var<storage, read> starts: array<u32>;
@group(0) @binding(2) var<storage, read> active_blocks: array<ActiveBlock>;
@group(0) @binding(3) var<storage, read> vertex_counts: array<u32>;
@group(0) @binding(4) var<storage, read_write> entries: array<u32>;
// Workgroups for lists that are longer than `SHORT`: none where there is no such list.
@group(0) @binding(5) var<storage, read_write> long: array<atomic<u32>, 3>;

// What eight invocations hold: sixteen items each.
const SHORT: u32 = 128u;
// Beyond any item.
const NOTHING: u32 = 0xffffffffu;

// Every eighth item from one on.
fn items_from(at: u32, end: u32) -> vec4u {
    var items = vec4u(NOTHING);
    for (var index = 0u; index < 4u; index++) {
        if at + 8u * index < end {
            items[index] = entries[at + 8u * index];
        }
    }
    return items;
}

// How many of a list come before each of an invocation's items.
struct Ranks {
    a: vec4u,
    b: vec4u,
    c: vec4u,
    d: vec4u,
}

fn put(first: u32, items: vec4u, ranks: vec4u) {
    for (var index = 0u; index < 4u; index++) {
        if items[index] != NOTHING {
            entries[first + ranks[index]] = items[index];
        }
    }
}

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = (group.y * groups.x + group.x) * 8u + lane / 8u;
    var list = vec2u(0u);
    if slot < lattice.active_blocks && vertex_counts[slot] > 0u {
        let block = active_blocks[slot].number;
        list = vec2u(starts[block], starts[block + 1u]);
    }
    if list.y - list.x > SHORT {
        let rows = (lattice.active_blocks + 65534u) / 65535u;
        atomicStore(&long[0], (lattice.active_blocks + rows - 1u) / rows);
        atomicStore(&long[1], rows);
        atomicStore(&long[2], 1u);
        list.y = list.x;
    }
    let first = list.x + lane % 8u;
    let a = items_from(first, list.y);
    let b = items_from(first + 32u, list.y);
    let c = items_from(first + 64u, list.y);
    let d = items_from(first + 96u, list.y);
    var ranks = Ranks();
    for (var at = list.x; at < list.y; at++) {
        let other = vec4u(entries[at]);
        ranks.a += vec4u(other < a);
        ranks.b += vec4u(other < b);
        ranks.c += vec4u(other < c);
        ranks.d += vec4u(other < d);
    }
    // All have read before any writes.
    storageBarrier();
    put(list.x, a, ranks.a);
    put(list.x, b, ranks.b);
    put(list.x, c, ranks.c);
    put(list.x, d, ranks.d);
}
