// Puffs become blobs, and the lattice is laid around them.
//
// Shares are summed in a fixed order, so that the lattice is the same from run to run.

// What a stretch of blobs adds up to.
struct Share {
    low: vec3f,
    count: f32,
    high: vec3f,
    // Sums of the radius, its square and its cube.
    radii: f32,
    squares: f32,
    cubes: f32,
    // From the eye to the nearest ball; below zero inside one.
    nearest: f32,
    pad: f32,
}

@group(0) @binding(0) var<uniform> recipe: Recipe;
@group(0) @binding(1) var<storage, read> puffs: array<Puff>;
@group(0) @binding(2) var<storage, read_write> blobs: array<Blob>;
@group(0) @binding(3) var<storage, read_write> shares: array<Share>;
@group(0) @binding(4) var<storage, read_write> lattice: Lattice;

var<workgroup> gathered: array<Share, 256>;

// The weights of equation 2. Matter that erodes or fades from sight has ever less hold on the surface.
fn blob_of(puff: Puff) -> Blob {
    let radius = puff.radius * recipe.radius_scale;
    let fade = puff_fade(puff);
    let mass = puff.mass * recipe.mass_scale * (1.0 - fade.x) * fade.y;
    let sane = is_sane(puff.center.x) && is_sane(puff.center.y) && is_sane(puff.center.z)
        && is_sane(radius) && is_sane(mass);
    if !sane || radius < LEAST || mass < LEAST {
        return Blob(vec3f(0.0), 0.0, 0.0, 0.0, vec2f(0.0));
    }
    return Blob(puff.center, radius, mass, 1.0 / (radius * radius), vec2f(0.0));
}

fn nothing() -> Share {
    return Share(vec3f(3e38), 0.0, vec3f(-3e38), 0.0, 0.0, 0.0, 3e38, 0.0);
}

fn share_of(blob: Blob) -> Share {
    if blob.radius == 0.0 {
        return nothing();
    }
    let r = blob.radius;
    let nearest = distance(blob.center, recipe.eye) - r;
    return Share(blob.center - r, 1.0, blob.center + r, r, r * r, r * r * r, nearest, 0.0);
}

fn together(a: Share, b: Share) -> Share {
    return Share(
        min(a.low, b.low),
        a.count + b.count,
        max(a.high, b.high),
        a.radii + b.radii,
        a.squares + b.squares,
        a.cubes + b.cubes,
        min(a.nearest, b.nearest),
        0.0,
    );
}

// Adds up all lanes' shares.
fn gather(lane: u32, own: Share) -> Share {
    gathered[lane] = own;
    for (var half = 128u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if lane < half {
            gathered[lane] = together(gathered[lane], gathered[lane + half]);
        }
    }
    workgroupBarrier();
    return gathered[0];
}

@compute @workgroup_size(256)
fn weigh(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let stretch = group.y * groups.x + group.x;
    let item = stretch * 256u + lane;
    var own = nothing();
    if item < recipe.count {
        let blob = blob_of(puffs[recipe.first + item]);
        blobs[item] = blob;
        own = share_of(blob);
    }
    let sum = gather(lane, own);
    if lane == 0u && stretch * 256u < recipe.count {
        shares[stretch] = sum;
    }
}

@compute @workgroup_size(256)
fn fit(@builtin(local_invocation_index) lane: u32) {
    var own = nothing();
    for (var stretch = lane; stretch * 256u < recipe.count; stretch += 256u) {
        own = together(own, shares[stretch]);
    }
    let total = gather(lane, own);
    if lane == 0u {
        lattice = fitted(total);
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

fn fitted(total: Share) -> Lattice {
    if total.count == 0.0 {
        return Lattice(vec3i(0), 1.0, vec3u(0u), 0u, 0u);
    }
    var cell_m = recipe.cell_m;
    if cell_m == 0.0 {
        let extent = total.high - total.low;
        let longest = max(extent.x, max(extent.y, extent.z));
        let finest = longest / recipe.subdivisions;
        let coarsest = longest / min(LEAST_CELLS, recipe.subdivisions);
        let wanted = clamp(recipe.cell_per_m * max(total.nearest, 0.0), finest, coarsest);
        cell_m = exp2(ceil(4.0 * log2(wanted)) / 4.0);
    }
    var overflow = 0u;
    for (var step = 0u; step < STEPS && !fits(total, cell_m); step++) {
        cell_m *= STEP;
        overflow = COARSENED;
    }
    if !fits(total, cell_m) {
        return Lattice(vec3i(0), 1.0, vec3u(0u), 0u, overflow);
    }
    let first = first_block(total.low, cell_m);
    let blocks = last_block(total.high, cell_m) - first + 1.0;
    return Lattice(vec3i(first), cell_m, vec3u(blocks), 0u, overflow);
}

fn fits(total: Share, cell_m: f32) -> bool {
    let farthest = max(abs(total.low), abs(total.high)) / cell_m;
    let blocks = last_block(total.high, cell_m) - first_block(total.low, cell_m) + 1.0;
    return all(farthest <= vec3f(FARTHEST))
        && blocks.x * blocks.y * blocks.z <= f32(recipe.blocks)
        && touched(total, cell_m) <= f32(recipe.entries);
}

// The most blocks that all particles together can touch: (r / 2c + 2.2)³ each, for a particle is
// r / 2c blocks wide, and 2.2 allows for `SLACK` and for blocks that it touches at their rim.
fn touched(total: Share, cell_m: f32) -> f32 {
    let per_cell = 0.5 / cell_m;
    return ((total.cubes * per_cell + 6.6 * total.squares) * per_cell + 14.52 * total.radii) * per_cell
        + 10.648 * total.count;
}
