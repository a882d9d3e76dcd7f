// Puffs ─▶ the lists of tiles.

@group(0) @binding(1) var<uniform> bins: Bins;
@group(0) @binding(2) var projected: texture_storage_2d<rgba32uint, read>;
// As in `Summary`.
@group(0) @binding(3) var<storage, read_write> summary: array<atomic<u32>, 6>;
// How many are in each slice of a tile; then where the next one of a slice goes.
@group(0) @binding(4) var<storage, read_write> slices: array<atomic<u32>>;
// Where each tile's list begins and ends.
@group(0) @binding(5) var<storage, read_write> tiles: array<vec2u>;
// Column and row of those of level 0 that show anything.
@group(0) @binding(6) var<storage, read_write> covered: array<u32>;
// The same in runs.
@group(0) @binding(7) var<storage, read_write> runs: array<u32>;
// Arguments of a draw over the runs, and of a dispatch over the tiles.
@group(0) @binding(8) var<storage, read_write> draw: array<atomic<u32>, 4>;
@group(0) @binding(9) var<storage, read_write> dispatch: array<atomic<u32>, 3>;
@group(0) @binding(10) var entries: texture_storage_2d<rg32uint, write>;

// The tiles that a puff may touch.
struct Footprint {
    middle: vec2f,
    reach: f32,
    tile_px: f32,
    grid: vec4u,
    low: vec2u,
    // Beyond the last.
    end: vec2u,
    rank: u32,
}

fn footprint_of(item: u32) -> Footprint {
    let at = bitcast<vec4f>(textureLoad(projected, projected_at(item, 0u)));
    if at.z <= 0.0 {
        return Footprint(vec2f(0.0), 0.0, 1.0, vec4u(0u), vec2u(0u), vec2u(0u), 0u);
    }
    let reach_px = bitcast<f32>(textureLoad(projected, projected_at(item, 2u)).x);
    let level = min(u32(max(ceil(log2(reach_px * (1.001 / f32(TILE_PX)))), 0.0)), bins.levels - 1u);
    let grid = bins.level[level];
    let tile_px = f32(TILE_PX << level);
    let low = clamp(floor((at.xy - reach_px) / tile_px), vec2f(0.0), vec2f(grid.yz));
    let end = clamp(floor((at.xy + reach_px) / tile_px) + 1.0, vec2f(0.0), vec2f(grid.yz));
    let known = Summary(atomicLoad(&summary[0]), atomicLoad(&summary[1]), 0u, 0u, 0u, 0u);
    let rank = u32(rank_of(depth_of(at.w * (1.0 - at.z / view.focal_px)), known));
    return Footprint(at.xy, reach_px, tile_px, grid, vec2u(low), vec2u(end), rank);
}

// Whether a circle touches a square.
fn touches(footprint: Footprint, low: vec2f, side: f32) -> bool {
    let away = max(abs(low + 0.5 * side - footprint.middle) - 0.5 * side, vec2f(0.0));
    return dot(away, away) < footprint.reach * footprint.reach;
}

// A bit for each of a tile's blocks that a circle touches.
fn blocks_of(footprint: Footprint, low: vec2f) -> u32 {
    let side = 0.25 * footprint.tile_px;
    let middles = (vec4f(0.0, 1.0, 2.0, 3.0) + 0.5) * side;
    let across = max(abs(low.x + middles - footprint.middle.x) - 0.5 * side, vec4f(0.0));
    let down = max(abs(low.y + middles - footprint.middle.y) - 0.5 * side, vec4f(0.0));
    let room = footprint.reach * footprint.reach - down * down;
    var blocks = 0u;
    for (var row = 0u; row < 4u; row++) {
        let bits = select(vec4u(0u), vec4u(1u, 2u, 4u, 8u), across * across < vec4f(room[row]));
        blocks |= (bits.x | bits.y | bits.z | bits.w) << (4u * row);
    }
    return blocks;
}

fn item_of(group: vec3u, groups: vec3u, lane: u32) -> u32 {
    return (group.y * groups.x + group.x) * 256u + lane;
}

@compute @workgroup_size(256)
fn count(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = item_of(group, groups, lane);
    if item >= bins.count {
        return;
    }
    let footprint = footprint_of(item);
    for (var y = footprint.low.y; y < footprint.end.y; y++) {
        for (var x = footprint.low.x; x < footprint.end.x; x++) {
            if touches(footprint, vec2f(vec2u(x, y)) * footprint.tile_px, footprint.tile_px) {
                let tile = footprint.grid.x + y * footprint.grid.y + x;
                atomicAdd(&slices[tile * SLICES + slice_of(footprint.rank)], 1u);
            }
        }
    }
}

// Gives every tile room for its list, and every slice its place in there. Lists may lie in any order.
@compute @workgroup_size(256)
fn place(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let tile = item_of(group, groups, lane);
    if tile >= arrayLength(&tiles) {
        return;
    }
    var sum = 0u;
    for (var slice = 0u; slice < SLICES; slice++) {
        sum += atomicLoad(&slices[tile * SLICES + slice]);
    }
    if sum == 0u {
        tiles[tile] = vec2u(0u);
        return;
    }
    var at = atomicAdd(&summary[2], sum);
    tiles[tile] = vec2u(at, at + sum);
    for (var slice = 0u; slice < SLICES; slice++) {
        let here = atomicLoad(&slices[tile * SLICES + slice]);
        atomicStore(&slices[tile * SLICES + slice], at);
        at += here;
    }
    for (var level = bins.levels; level > 0u; level--) {
        if tile >= bins.level[level - 1u].x {
            atomicOr(&summary[3], 1u << (level - 1u));
            break;
        }
    }
}

// A bit for each covered tile in each row of a workgroup's.
var<workgroup> rows: array<atomic<u32>, COVER_TILES.y>;

fn shows_anything(at: vec2u) -> bool {
    var any = false;
    for (var levels = atomicLoad(&summary[3]); levels != 0u; levels &= levels - 1u) {
        let list = tiles[level_tile(firstTrailingBit(levels), at * TILE_PX)];
        any |= list.y > list.x;
    }
    return any;
}

// Lists the tiles in which there is anything, of any level; and runs of them, for few large rectangles are set up sooner
// than many small ones.
@compute @workgroup_size(COVER_TILES.x, COVER_TILES.y)
fn cover(@builtin(global_invocation_id) id: vec3u, @builtin(local_invocation_id) lane: vec3u) {
    let at = id.xy;
    if all(at < bins.level[0].yz) && shows_anything(at) {
        let index = atomicAdd(&summary[5], 1u);
        covered[index] = at.x | (at.y << 16u);
        let group = index / WALK_TILES;
        atomicMax(&dispatch[0], min(group + 1u, WALK_ROW));
        atomicMax(&dispatch[1], group / WALK_ROW + 1u);
        atomicStore(&dispatch[2], 1u);
        atomicOr(&rows[lane.y], 1u << lane.x);
    }
    workgroupBarrier();
    let row = atomicLoad(&rows[lane.y]);
    let begins = (row & ~(row << 1u)) >> lane.x;
    if (begins & 1u) != 0u {
        let index = atomicAdd(&draw[1], 1u);
        runs[index] = run_packed(at, countTrailingZeros(~(row >> lane.x)));
        atomicStore(&draw[0], 6u);
    }
}

// Each slice of a list is filled in any order.
@compute @workgroup_size(256)
fn list(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = item_of(group, groups, lane);
    if item >= bins.count {
        return;
    }
    let footprint = footprint_of(item);
    for (var y = footprint.low.y; y < footprint.end.y; y++) {
        for (var x = footprint.low.x; x < footprint.end.x; x++) {
            let low = vec2f(vec2u(x, y)) * footprint.tile_px;
            if touches(footprint, low, footprint.tile_px) {
                let tile = footprint.grid.x + y * footprint.grid.y + x;
                let at = atomicAdd(&slices[tile * SLICES + slice_of(footprint.rank)], 1u);
                textureStore(entries, entry_at(at), vec4u(item, (footprint.rank << 16u) | blocks_of(footprint, low), 0u, 0u));
            }
        }
    }
}
