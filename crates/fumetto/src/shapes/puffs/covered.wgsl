// Draws the tiles that show anything, from what was found for them.

@group(0) @binding(0) var<uniform> bins: Bins;
@group(0) @binding(1) var<storage, read> runs: array<u32>;
@group(0) @binding(2) var found: texture_storage_2d<rgba32uint, read>;

@vertex
fn vertex(@builtin(vertex_index) index: u32, @builtin(instance_index) instance: u32) -> @builtin(position) vec4f {
    let run = run_unpacked(runs[instance]);
    let corner = array(0u, 2u, 3u, 0u, 3u, 1u)[index % 6u];
    let px = vec2f((run.xy + vec2u(corner & 1u, corner >> 1u) * vec2u(run.z, 1u)) * TILE_PX);
    let ndc = px / bins.size_px * 2.0 - 1.0;
    return vec4f(ndc.x, -ndc.y, 0.5, 1.0);
}

