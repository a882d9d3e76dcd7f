// Where the bricks of a file's voxels are found, and what lies between voxels. Uses `linear` of the program that it is
// part of.
//
// A brick has 8³ voxels, and one more layer at its upper sides: what lies between voxels is found in one brick, by
// the texture unit. Nodes of 16³ bricks tell where each brick lies in the atlas, and one table where each node does.

@group(0) @binding(3) var<storage, read> bricks: BrickGrid;
// For each node where its bricks begin here, or 0; then for each brick of those nodes where it lies in the atlas, or,
// without matter, how many bricks it is away from one that has some.
@group(0) @binding(4) var<storage, read> table: array<u32>;
// Density, and density times heat.
@group(0) @binding(5) var atlas: texture_3d<f32>;

struct BrickGrid {
    // Voxels are counted from the corner of the first node, at their middles.
    voxel_from_world: mat4x4f,
    world_from_voxel: mat4x4f,
    // The box around all matter, in voxels.
    low: vec3f,
    // The density that 1 in the atlas stands for.
    peak: f32,
    high: vec3f,
    // Side of a cell of light, in voxels.
    light_side: f32,
    // None where there is no matter.
    nodes: vec3u,
    has_heat: u32,
    light_sides: vec3u,
    // Bricks along the sides of the atlas.
    slots: vec3u,
}

// Also in `map.rs`.
const BRICK: u32 = 8u;
const SIDE_IN_ATLAS: u32 = 9u;
const NODE: u32 = 16u;

// Of a kept brick's entry, and its bits for each coordinate in the atlas. Also in `table.rs`.
const IS_KEPT: u32 = 2147483648u;
const SLOT_BITS: u32 = 8u;

fn cell_of(place: vec3f) -> vec3f {
    return (bricks.voxel_from_world * vec4f(place, 1.0)).xyz;
}

fn cells_along(way: vec3f) -> vec3f {
    return (bricks.voxel_from_world * vec4f(way, 0.0)).xyz;
}

fn slope_in_world(slope: vec3f) -> vec3f {
    return (vec4f(slope, 0.0) * bricks.voxel_from_world).xyz;
}

// What the table tells of a brick.
struct Entry {
    is_kept: bool,
    // Of a kept one: its place in the atlas, in bricks. To number slots instead would take whole divisions here, which
    // a processor that draws does one by one.
    slot: vec3u,
    // Of any other: first brick of a void around it, and how many it is wide.
    low: vec3i,
    width: u32,
}

fn entry_of(brick: vec3u) -> Entry {
    let node = brick / NODE;
    let first = table[(node.z * bricks.nodes.y + node.y) * bricks.nodes.x + node.x];
    if first == 0u {
        return Entry(false, vec3u(0u), vec3i(node * NODE), NODE);
    }
    let within = brick % NODE;
    let entry = table[first + (within.z * NODE + within.y) * NODE + within.x];
    let slot = (vec3u(entry) >> vec3u(0u, SLOT_BITS, 2u * SLOT_BITS)) & vec3u((1u << SLOT_BITS) - 1u);
    return Entry((entry & IS_KEPT) != 0u, slot, vec3i(brick) - i32(entry) + 1, 2u * entry - 1u);
}

fn is_outside(at: vec3f) -> bool {
    return any(at < vec3f(0.0)) || any(at >= vec3f(bricks.nodes * (BRICK * NODE)));
}

fn sample_at(at: vec3f) -> vec4f {
    if is_outside(at) {
        return vec4f(0.0);
    }
    let voxel = vec3u(at);
    let entry = entry_of(voxel / BRICK);
    if !entry.is_kept {
        return vec4f(0.0);
    }
    let texel = vec3f(entry.slot * SIDE_IN_ATLAS) + 0.5 + (at - vec3f(voxel / BRICK * BRICK));
    return textureSampleLevel(atlas, linear, texel / vec3f(bricks.slots * SIDE_IN_ATLAS), 0.0);
}

fn density_of(sample: vec4f) -> f32 {
    return sample.r * bricks.peak;
}
