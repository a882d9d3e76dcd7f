// Puffs become blobs, and the lattice is laid around them.
//
// Shares are summed in a fixed order, so that the lattice is the same from run to run.

// What a stretch of blobs adds up to. By fours, for a processor that draws takes as long to read one number.
struct Share {
    // The lowest corner, and how far the nearest ball is from the eye: below zero from inside one.
    lowest: vec4f,
    // The highest corner, and the largest radius.
    highest: vec4f,
    // How many there are, and sums of the radius, its square and its cube.
    sums: vec4f,
}

@group(0) @binding(0) var<uniform> recipe: Recipe;
// Puffs, as they lie in memory.
@group(0) @binding(1) var<storage, read> puffs: array<array<vec4u, 2>>;
@group(0) @binding(2) var<storage, read_write> blobs: array<PackedBlob>;
@group(0) @binding(3) var<storage, read_write> shares: array<Share>;
@group(0) @binding(4) var<storage, read_write> lattice: Lattice;

var<workgroup> gathered: array<Share, 256>;

// Particles that a workgroup weighs. Also in `bounds.rs`.
const STRETCH: u32 = 1024u;

fn puff_of(words: array<vec4u, 2>) -> Puff {
    let ball = bitcast<vec4f>(words[0]);
    return Puff(ball.xyz, ball.w, words[1].x, words[1].y, bitcast<f32>(words[1].z), 0.0);
}

// The weights of equation 2. Matter that erodes or fades from sight has ever less hold on the surface.
fn blob_of(puff: Puff, scales: vec2f) -> Blob {
    let radius = puff.radius * scales.x;
    let fade = puff_fade(puff);
    let mass = puff.mass * scales.y * (1.0 - fade.x) * fade.y;
    let sane = is_sane(puff.center.x) && is_sane(puff.center.y) && is_sane(puff.center.z)
        && is_sane(radius) && is_sane(mass);
    if !sane || radius < LEAST || mass < LEAST {
        return Blob(vec3f(0.0), 0.0, 0.0, 0.0);
    }
    return Blob(puff.center, radius, mass, 1.0 / (radius * radius));
}

fn nothing() -> Share {
    return Share(vec4f(3e38), vec4f(vec3f(-3e38), 0.0), vec4f(0.0));
}

fn share_of(blob: Blob, eye: vec3f) -> Share {
    if blob.radius == 0.0 {
        return nothing();
    }
    let r = blob.radius;
    let nearest = distance(blob.center, eye) - r;
    return Share(vec4f(blob.center - r, nearest), vec4f(blob.center + r, r), vec4f(1.0, r, r * r, r * r * r));
}

fn together(a: Share, b: Share) -> Share {
    return Share(min(a.lowest, b.lowest), max(a.highest, b.highest), a.sums + b.sums);
}

// Adds up all lanes' shares: sixteen lanes sixteen each, and one lane these. Barriers are what costs most where a
// processor draws, and this has few.
fn gather(lane: u32, own: Share) -> Share {
    gathered[lane] = own;
    workgroupBarrier();
    if lane < 16u {
        gathered[16u * lane] = sum_of(16u * lane, 1u);
    }
    workgroupBarrier();
    if lane == 0u {
        gathered[0] = sum_of(0u, 16u);
    }
    workgroupBarrier();
    return gathered[0];
}

fn sum_of(first: u32, stride: u32) -> Share {
    var sum = gathered[first];
    for (var index = 1u; index < 16u; index++) {
        sum = together(sum, gathered[first + stride * index]);
    }
    return sum;
}

@compute @workgroup_size(256)
fn weigh(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let stretch = group.y * groups.x + group.x;
    let scales = vec2f(recipe.radius_scale, recipe.mass_scale);
    let eye = recipe.eye;
    let first = recipe.first;
    let end = min((stretch + 1u) * STRETCH, recipe.count);
    var own = nothing();
    for (var item = stretch * STRETCH + lane; item < end; item += 256u) {
        let blob = blob_of(puff_of(puffs[first + item]), scales);
        blobs[item] = packed(blob);
        own = together(own, share_of(blob, eye));
    }
    let sum = gather(lane, own);
    if lane == 0u && stretch * STRETCH < recipe.count {
        shares[stretch] = sum;
    }
}

@compute @workgroup_size(256)
fn fit(@builtin(local_invocation_index) lane: u32) {
    var own = nothing();
    for (var stretch = lane; stretch * STRETCH < recipe.count; stretch += 256u) {
        own = together(own, shares[stretch]);
    }
    let total = gather(lane, own);
    if lane == 0u {
        lay(total);
    }
}

// A quarter of an octave: the steps that cells come in, so that cells seldom change.
const STEP: f32 = 1.1892071;
// Steps from the smallest cell to one that holds everything `MOST` allows.
const STEPS: u32 = 400u;
// A cell is no larger than this part of the longest side. Also in `sight.rs`.
const LEAST_CELLS: f32 = 8.0;
// In cells. Single floats place what lies this far from the origin to within a hundredth of a cell.
const FARTHEST: f32 = 65536.0;

// A lattice around everything.
struct Frame {
    first: vec3i,
    cell_m: f32,
    regions: vec3u,
}

fn lay(total: Share) {
    var asked_m = recipe.cell_m;
    if asked_m == 0.0 {
        let extent = (total.highest - total.lowest).xyz;
        let longest = max(extent.x, max(extent.y, extent.z));
        let finest = longest / recipe.subdivisions;
        let coarsest = longest / min(LEAST_CELLS, recipe.subdivisions);
        let wanted = clamp(recipe.cell_per_m * max(total.lowest.w, 0.0), finest, coarsest);
        asked_m = exp2(ceil(4.0 * log2(wanted)) / 4.0);
    }
    var cell_m = asked_m;
    for (var step = 0u; step < STEPS && !may_fit(total, cell_m); step++) {
        cell_m *= STEP;
    }
    var safe_m = cell_m;
    for (var step = 0u; step < STEPS && !fits(total, safe_m); step++) {
        safe_m *= STEP;
    }
    let frame = frame_of(total, cell_m);
    let safe = frame_of(total, safe_m);
    lattice.first = frame.first;
    lattice.cell_m = frame.cell_m;
    lattice.regions = frame.regions;
    lattice.safe_first = safe.first;
    lattice.safe_cell_m = safe.cell_m;
    lattice.safe_regions = safe.regions;
    lattice.widest_m = total.highest.w;
    lattice.active_blocks = 0u;
    lattice.overflow = select(0u, COARSENED, total.sums.x > 0.0 && cell_m > asked_m);
}

fn frame_of(total: Share, cell_m: f32) -> Frame {
    if total.sums.x == 0.0 || !may_fit(total, cell_m) {
        return Frame(vec3i(0), 1.0, vec3u(0u));
    }
    let first = first_cube(total.lowest.xyz, cell_m, REGION * BLOCK);
    return Frame(vec3i(first) * REGION, cell_m, vec3u(regions_around(total, cell_m)));
}

fn regions_around(total: Share, cell_m: f32) -> vec3f {
    let side = REGION * BLOCK;
    return last_cube(total.highest.xyz, cell_m, side) - first_cube(total.lowest.xyz, cell_m, side) + 1.0;
}

// Whether there is room for what particles touch if these are as many as one would expect, or a few times as
// many. `regions.wgsl` counts them.
fn may_fit(total: Share, cell_m: f32) -> bool {
    let farthest = max(abs(total.lowest.xyz), abs(total.highest.xyz)) / cell_m;
    let regions = regions_around(total, cell_m);
    return all(farthest <= vec3f(FARTHEST))
        && regions.x * regions.y * regions.z <= f32(recipe.regions)
        && touched(total, cell_m, USUAL) <= min(UNUSUALLY_MANY * f32(recipe.entries), MOST_COUNTED);
}

// Whether there is room whatever they touch.
fn fits(total: Share, cell_m: f32) -> bool {
    let regions = regions_around(total, cell_m);
    return may_fit(total, cell_m)
        && regions.x * regions.y * regions.z * f32(IN_REGION) <= f32(recipe.blocks)
        && touched(total, cell_m, MOST_WIDER) <= f32(recipe.entries);
}

// Blocks that boxes around particles are wider than the r / 2c of the particles: at most, for `SLACK` and those
// that they touch at their rim; and on average, if particles lie anywhere.
const MOST_WIDER: f32 = 2.2;
const USUAL: f32 = 1.125;
const UNUSUALLY_MANY: f32 = 4.0;
// A sum of boxes, of which each may be (2.2 / 1.125)³ times as large, is less than 2³².
const MOST_COUNTED: f32 = 5e8;

// Blocks in the boxes of all particles together: the sum of (r / 2c + wider)³.
fn touched(total: Share, cell_m: f32, wider: f32) -> f32 {
    let per_cell = 0.5 / cell_m;
    let square = wider * wider;
    return ((total.sums.w * per_cell + 3.0 * wider * total.sums.z) * per_cell + 3.0 * square * total.sums.y) * per_cell
        + square * wider * total.sums.x;
}
