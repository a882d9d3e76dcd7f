// Heat and smoke fade, and sources bring new ones.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read> fixed: array<vec2f>;
@group(0) @binding(2) var<storage, read_write> heat: array<vec2f>;
@group(0) @binding(3) var<storage, read> sources: array<Source>;
@group(0) @binding(4) var<storage, read_write> smoky: array<atomic<u32>>;
@group(0) @binding(5) var<storage, read> busy: array<u32>;

// Less than this is none.
const LEAST: f32 = 1e-3;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let block = busy[BUSY + group.x];
    for (var half = 0u; half < 2u; half++) {
        let c = cell_of(block, lane, half);
        let p = grid.origin + (vec3f(c) + 0.5) * grid.side;
        var both = fixed[cell_index(c)] * grid.fade;
        for (var i = 0u; i < grid.sources; i++) {
            both = max(both, share_of(sources[i], p) * vec2f(sources[i].heat, sources[i].smoke));
        }
        let is_there = max(both.x, both.y) > LEAST;
        heat[cell_index(c)] = select(vec2f(0.0), both, is_there);
        if is_there {
            atomicStore(&smoky[block], 1u);
        }
    }
}
