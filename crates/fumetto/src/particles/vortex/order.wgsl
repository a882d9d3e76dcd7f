// Where vortices are along a Hilbert curve through the box around them: neighbours on it are neighbours in
// space.

@group(0) @binding(0) var<uniform> tree: Tree;
@group(0) @binding(1) var<storage, read> vortices: array<Vortex>;
@group(0) @binding(2) var<storage, read> halfway: array<vec4f>;
// The box's lowest corner; its longest side.
@group(0) @binding(3) var<storage, read_write> bounds: vec4f;
// Place on the curve, and whose it is.
@group(0) @binding(4) var<storage, read_write> keys: array<vec2u>;

// The curve runs through 2¹⁰ cells along each side.
const BITS: u32 = 10u;

fn position_of(slot: u32) -> vec3f {
    return select(vortices[slot].position, halfway[slot].xyz, tree.halfway == 1u);
}

var<workgroup> lows: array<vec3f, 256>;
var<workgroup> highs: array<vec3f, 256>;

// One workgroup; each lane takes every 256th vortex.
@compute @workgroup_size(256)
fn find_bounds(@builtin(local_invocation_index) lane: u32) {
    lows[lane] = vec3f(1e30);
    highs[lane] = vec3f(-1e30);
    for (var slot = lane; slot < tree.count; slot += 256u) {
        if spins(vortices[slot]) {
            lows[lane] = min(lows[lane], position_of(slot));
            highs[lane] = max(highs[lane], position_of(slot));
        }
    }
    for (var half = 128u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if lane < half {
            lows[lane] = min(lows[lane], lows[lane + half]);
            highs[lane] = max(highs[lane], highs[lane + half]);
        }
    }
    if lane == 0u {
        let sides = highs[0] - lows[0];
        bounds = vec4f(lows[0], max(max(sides.x, sides.y), max(sides.z, 1e-9)));
    }
}

// The ten lowest bits with two zeros before each.
fn spread_bits(value: u32) -> u32 {
    var bits = value & 0x3ffu;
    bits = (bits | (bits << 16u)) & 0x030000ffu;
    bits = (bits | (bits << 8u)) & 0x0300f00fu;
    bits = (bits | (bits << 4u)) & 0x030c30c3u;
    return (bits | (bits << 2u)) & 0x09249249u;
}

// The number of a cell along the curve (Skilling 2004, "Programming the Hilbert curve").
fn hilbert(cell: vec3u) -> u32 {
    var x = cell;
    for (var q = 1u << (BITS - 1u); q > 1u; q >>= 1u) {
        let p = q - 1u;
        for (var i = 0u; i < 3u; i++) {
            if (x[i] & q) != 0u {
                x.x ^= p;
            } else {
                let swapped = (x.x ^ x[i]) & p;
                x.x ^= swapped;
                x[i] ^= swapped;
            }
        }
    }
    x.y ^= x.x;
    x.z ^= x.y;
    var turn = 0u;
    for (var q = 1u << (BITS - 1u); q > 1u; q >>= 1u) {
        if (x.z & q) != 0u {
            turn ^= q - 1u;
        }
    }
    x ^= vec3u(turn);
    return (spread_bits(x.x) << 2u) | (spread_bits(x.y) << 1u) | spread_bits(x.z);
}

// Places without a vortex come last.
@compute @workgroup_size(256)
fn find_keys(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = group.x * 256u + lane;
    if slot >= tree.count || !spins(vortices[slot]) {
        keys[slot] = vec2u(0xffffffffu, slot);
        return;
    }
    let most = f32((1u << BITS) - 1u);
    let cell = clamp((position_of(slot) - bounds.xyz) / bounds.w, vec3f(0.0), vec3f(1.0)) * most;
    keys[slot] = vec2u(hilbert(vec3u(cell)), slot);
}
