// Sorts cells into the 256 cases of marching cubes, and counts their vertices and triangles.

@group(0) @binding(0) var<storage, read> lattice: Lattice;
@group(0) @binding(1) var<storage, read> states: array<u32>;
@group(0) @binding(2) var<storage, read> active_blocks: array<u32>;
@group(0) @binding(3) var<storage, read> signs: array<vec2u>;
@group(0) @binding(4) var<storage, read> polygons: array<vec2u>;
@group(0) @binding(5) var<storage, read_write> cells: array<u32>;
@group(0) @binding(6) var<storage, read_write> vertex_counts: array<u32>;
@group(0) @binding(7) var<storage, read_write> triangle_counts: array<u32>;

// Vertices in the lower half, triangles in the upper.
var<workgroup> counts: array<u32, 64>;

fn is_inside(place: vec3u) -> u32 {
    let state = neighbours[neighbour_of(place)];
    if state < ACTIVE {
        return state;
    }
    let point = local_number(place & vec3u(3u));
    return (signs[state - ACTIVE][point / 32u] >> (point % 32u)) & 1u;
}

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = group.y * groups.x + group.x;
    if slot >= lattice.active_blocks {
        return;
    }
    meet_neighbours(active_blocks[slot], lane);
    workgroupBarrier();
    var corners = 0u;
    for (var corner = 0u; corner < 8u; corner++) {
        let step = (vec3u(corner) >> vec3u(0u, 1u, 2u)) & vec3u(1u);
        corners |= is_inside(local_place(lane) + step) << corner;
    }
    let own = countOneBits(own_crossings(corners)) | (triangles_of(polygons[corners]) << 16u);
    let before = sum_before(lane, own);
    cells[slot * 64u + lane] = corners | ((before & 0xffu) << 8u) | (before & 0xffff0000u);
    if lane == 63u {
        vertex_counts[slot] = (before + own) & 0xffffu;
        triangle_counts[slot] = (before + own) >> 16u;
    }
}

// The sum of what lower lanes have (Hillis & Steele 1986).
fn sum_before(lane: u32, own: u32) -> u32 {
    counts[lane] = own;
    workgroupBarrier();
    for (var gap = 1u; gap < 64u; gap *= 2u) {
        var sum = counts[lane];
        if lane >= gap {
            sum += counts[lane - gap];
        }
        workgroupBarrier();
        counts[lane] = sum;
        workgroupBarrier();
    }
    return counts[lane] - own;
}
