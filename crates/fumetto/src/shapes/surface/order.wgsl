// Brings blobs that lie near each other together in memory: where there are very many, all that follows would else wait
// for memory. Their order decides nothing.

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> lattice: Lattice;
@group(0) @binding(2) var<storage, read> loose: array<PackedBlob>;
// Blobs in each bucket; none before and after.
@group(0) @binding(3) var<storage, read_write> tally: array<atomic<u32>>;
// How many are in buckets before each.
@group(0) @binding(4) var<storage, read> starts: array<u32>;
@group(0) @binding(5) var<storage, read_write> blobs: array<PackedBlob>;

// Buckets along each side of the lattice. Also in `order.rs`.
const ALONG: f32 = 16.0;

// From a place to the lattice's share of buckets.
struct Buckets {
    low_m: vec3f,
    per_m: vec3f,
}

fn buckets() -> Buckets {
    let grid = grid();
    let block_m = f32(BLOCK) * grid.cell_m;
    return Buckets(vec3f(grid.first) * block_m, ALONG / (vec3f(max(grid.regions, vec3u(1u))) * f32(REGION) * block_m));
}

fn bucket_of(buckets: Buckets, blob: PackedBlob) -> u32 {
    let at = vec3u(clamp((blob.ball.xyz - buckets.low_m) * buckets.per_m, vec3f(0.0), vec3f(ALONG - 1.0)));
    return number_in(vec3u(u32(ALONG)), at);
}

@compute @workgroup_size(64)
fn count(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let buckets = buckets();
    let item = (group.y * groups.x + group.x) * 64u + lane;
    if item < recipe.count {
        atomicAdd(&tally[bucket_of(buckets, loose[item])], 1u);
    }
}

// Buckets are filled from their end, which takes the tallies back to zero for the next frame.
@compute @workgroup_size(64)
fn settle(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let buckets = buckets();
    let item = (group.y * groups.x + group.x) * 64u + lane;
    if item < recipe.count {
        let blob = loose[item];
        let bucket = bucket_of(buckets, blob);
        blobs[starts[bucket] + atomicSub(&tally[bucket], 1u) - 1u] = blob;
    }
}
