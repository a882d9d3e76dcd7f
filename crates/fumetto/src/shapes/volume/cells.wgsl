// The field of puffs: density in the cells of a grid. `bricks.wgsl` says the same of files. Uses `linear` of the
// program that it is part of.

@group(0) @binding(3) var<storage, read> grid: VolumeGrid;
@group(0) @binding(4) var<storage, read> occupied: array<u32>;
// Colour times density, and density.
@group(0) @binding(5) var density: texture_3d<f32>;

fn is_nothing() -> bool {
    return grid.cells.x == 0u;
}

// The box around all matter, in cells.
fn low_end() -> vec3f {
    return vec3f(0.0);
}

fn high_end() -> vec3f {
    return vec3f(grid.cells);
}

// From the world to cells: a place, and a way.
fn cell_of(place: vec3f) -> vec3f {
    return (place - grid.origin) / grid.cell_m;
}

fn cells_along(way: vec3f) -> vec3f {
    return way / grid.cell_m;
}

// From a slope in cells to its direction in the world.
fn slope_in_world(slope: vec3f) -> vec3f {
    return slope;
}

fn void_at(at: vec3f) -> Void {
    let block = vec3u(clamp(at, vec3f(0.0), vec3f(grid.cells) - 0.5)) / BLOCK;
    let is_empty = occupied[block_number(block, grid.cells)] == 0u;
    return Void(vec3f(block * BLOCK), select(0.0, f32(BLOCK), is_empty));
}

// What is at a place, and the parts of it.
fn sample_at(at: vec3f) -> vec4f {
    return textureSampleLevel(density, linear, at / vec3f(grid.cells), 0.0);
}

fn density_of(sample: vec4f) -> f32 {
    return sample.a;
}

fn colour_of(sample: vec4f) -> vec3f {
    return sample.rgb / sample.a;
}

// How much of `Recipe.glow` it gives off.
fn heat_of(sample: vec4f) -> f32 {
    return 1.0;
}

// Side of a cell of light, in cells.
fn light_side() -> f32 {
    return grid.light_cell_m / grid.cell_m;
}

fn light_sides() -> vec3u {
    return grid.light_cells;
}

// Where a cell of light lies in the world.
fn light_place(cell: vec3u) -> vec3f {
    return grid.origin + (vec3f(cell) + 0.5) * grid.light_cell_m;
}
