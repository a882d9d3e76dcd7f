// The form of a whole cloud: the gradient of its particles' density, smoothed to the size of its large
// lobes. A cartoonist shades the cloud, not each ball.
//
// Matter is counted in integers, so that the sum does not depend on the order of adding.

struct Object {
    first: u32,
    count: u32,
    index: u32,
    // Cells along each side of the grid that every object has in the texture.
    side: u32,
}

@group(0) @binding(0) var<uniform> object: Object;
@group(0) @binding(1) var<storage, read> puffs: array<Puff>;
@group(0) @binding(2) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(3) var<storage, read_write> grids: array<FormGrid>;
@group(0) @binding(4) var<storage, read_write> matter: array<atomic<u32>>;
@group(0) @binding(5) var<storage, read> blurred_from: array<f32>;
@group(0) @binding(6) var<storage, read_write> blurred_to: array<f32>;
@group(0) @binding(7) var field: texture_storage_3d<rgba16float, write>;

// Cells that smoothing reaches to each side, and that the grid adds around the matter.
const REACH: i32 = 4;
// What one typical puff counts for.
const UNIT: f32 = 256.0;

var<workgroup> low: array<vec3f, 256>;
var<workgroup> high: array<vec3f, 256>;
// Sums of volume and of volume times radius.
var<workgroup> sums: array<vec2f, 256>;

// One workgroup finds the bounds and the typical radius.
@compute @workgroup_size(256)
fn measure(@builtin(local_invocation_index) lane: u32) {
    var own_low = vec3f(3e38);
    var own_high = vec3f(-3e38);
    var own_sums = vec2f(0.0);
    for (var item = lane; item < object.count; item += 256u) {
        let puff = puffs[object.first + item];
        if puff.radius > 0.0 {
            own_low = min(own_low, puff.center);
            own_high = max(own_high, puff.center);
            let volume = puff.radius * puff.radius * puff.radius;
            own_sums += volume * vec2f(1.0, puff.radius);
        }
    }
    low[lane] = own_low;
    high[lane] = own_high;
    sums[lane] = own_sums;
    for (var half = 128u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if lane < half {
            low[lane] = min(low[lane], low[lane + half]);
            high[lane] = max(high[lane], high[lane + half]);
            sums[lane] += sums[lane + half];
        }
    }
    if lane == 0u {
        grids[object.index] = fit(low[0], high[0], sums[0]);
    }
}

// The grid for matter within these bounds. Its cells come in steps and lie on multiples of their size,
// so that it does not crawl over moving smoke.
fn fit(least: vec3f, most: vec3f, sum: vec2f) -> FormGrid {
    if sum.x <= 0.0 {
        return FormGrid(vec3f(0.0), 1.0, vec3u(0u), 1.0, 1.0, vec3f(0.0));
    }
    let radius = sum.y / sum.x;
    let sigma = radius * styles[object.index].form_scale;
    let extent = most - least;
    let longest = max(extent.x, max(extent.y, extent.z));
    let room = f32(object.side) - f32(2 * REACH) - 2.0;
    let cell = exp2(ceil(4.0 * log2(max(0.5 * sigma, longest / room))) / 4.0);
    let first = floor(least / cell) - f32(REACH);
    let cells = vec3u(floor(most / cell) - first) + u32(REACH) + 1u;
    return FormGrid(first * cell, cell, min(cells, vec3u(object.side)), max(sigma / cell, 0.7), radius, vec3f(0.0));
}

fn cell_index(at: vec3u) -> u32 {
    return ((object.index * object.side + at.z) * object.side + at.y) * object.side + at.x;
}

// Shares every puff's matter among the eight cells around its middle.
@compute @workgroup_size(256)
fn splat(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= object.count {
        return;
    }
    let puff = puffs[object.first + item];
    let fade = puff_fade(puff);
    if puff.radius <= 0.0 {
        return;
    }
    let grid = grids[object.index];
    let relative = puff.radius / grid.radius;
    let amount = UNIT * clamp(puff.mass * relative * relative * relative, 0.0, 64.0) * (1.0 - fade.x) * fade.y;
    let at = (puff.center - grid.origin) / grid.cell - 0.5;
    let cell = vec3u(max(floor(at), vec3f(0.0)));
    let part = at - floor(at);
    for (var corner = 0u; corner < 8u; corner++) {
        let step = vec3u(corner, corner >> 1u, corner >> 2u) & vec3u(1u);
        let weight = select(1.0 - part, part, step == vec3u(1u));
        let to = min(cell + step, grid.cells - 1u);
        atomicAdd(&matter[cell_index(to)], u32(amount * weight.x * weight.y * weight.z));
    }
}

@compute @workgroup_size(8, 8, 4)
fn blur_x(@builtin(global_invocation_id) id: vec3u) {
    if any(id >= grids[object.index].cells) {
        return;
    }
    let sigma = grids[object.index].sigma;
    var sum = 0.0;
    for (var step = -REACH; step <= REACH; step++) {
        let x = i32(id.x) + step;
        if x >= 0 && x < i32(grids[object.index].cells.x) {
            sum += exp(-0.5 * f32(step * step) / (sigma * sigma)) * f32(atomicLoad(&matter[cell_index(vec3u(u32(x), id.yz))]));
        }
    }
    blurred_to[cell_index(id)] = sum;
}

fn blurred(id: vec3u, axis: vec3i) -> f32 {
    let sigma = grids[object.index].sigma;
    let cells = vec3i(grids[object.index].cells);
    var sum = 0.0;
    for (var step = -REACH; step <= REACH; step++) {
        let at = vec3i(id) + axis * step;
        if all(at >= vec3i(0)) && all(at < cells) {
            sum += exp(-0.5 * f32(step * step) / (sigma * sigma)) * blurred_from[cell_index(vec3u(at))];
        }
    }
    return sum;
}

@compute @workgroup_size(8, 8, 4)
fn blur_y(@builtin(global_invocation_id) id: vec3u) {
    if all(id < grids[object.index].cells) {
        blurred_to[cell_index(id)] = blurred(id, vec3i(0, 1, 0));
    }
}

@compute @workgroup_size(8, 8, 4)
fn blur_z(@builtin(global_invocation_id) id: vec3u) {
    if all(id < grids[object.index].cells) {
        blurred_to[cell_index(id)] = blurred(id, vec3i(0, 0, 1));
    }
}

fn density(at: vec3i) -> f32 {
    let inside = clamp(at, vec3i(0), vec3i(grids[object.index].cells) - 1);
    return blurred_from[cell_index(vec3u(inside))];
}

// The outward direction, as long as the density falls steeply.
@compute @workgroup_size(8, 8, 4)
fn gradient(@builtin(global_invocation_id) id: vec3u) {
    if any(id >= vec3u(object.side)) {
        return;
    }
    var outward = vec3f(0.0);
    if all(id < grids[object.index].cells) {
        let at = vec3i(id);
        let slope = vec3f(
            density(at + vec3i(1, 0, 0)) - density(at - vec3i(1, 0, 0)),
            density(at + vec3i(0, 1, 0)) - density(at - vec3i(0, 1, 0)),
            density(at + vec3i(0, 0, 1)) - density(at - vec3i(0, 0, 1)),
        );
        // Relative to the density itself: a direction is as sure at the thin rim as in the thick.
        outward = -slope / max(density(at), 1e-3);
    }
    textureStore(field, vec3u(id.xy, object.index * object.side + id.z), vec4f(outward, 1.0));
}
