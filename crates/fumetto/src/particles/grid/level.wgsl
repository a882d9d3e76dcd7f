// One level of the pressure's multigrid: level 0 has the grid's own cells, each next one half as many along
// every side. All levels lie in one list, one after the other. Pressures are scaled to velocities: the difference
// between two cells is what it takes from the air on the face between them.

struct Level {
    cells: vec3u,
    // Where it begins in the lists.
    first: u32,
    // Likewise the next coarser one.
    coarser: u32,
    // A bit for each open wall: low x, high x, low y, high y, low z, high z.
    open: u32,
    // Of the cells that a pass visits: 0 those whose places add up to an even number, 1 the others.
    colour: u32,
    pad: u32,
}

@group(0) @binding(0) var<uniform> level: Level;
// What the differences from all neighbours should add up to.
@group(0) @binding(1) var<storage, read_write> wanted: array<f32>;
@group(0) @binding(2) var<storage, read_write> pressure: array<f32>;

fn index_in(cells: vec3u, c: vec3u) -> u32 {
    return (c.z * cells.y + c.y) * cells.x + c.x;
}

// The `item`-th cell of the colour.
fn coloured(item: vec3u) -> vec3u {
    return vec3u(2u * item.x + ((item.y + item.z + level.colour) & 1u), item.yz);
}

// The sum of the neighbours' pressures, and how often the cell's own is taken from it. A wall is no neighbour;
// on an open one pressure is zero, so that beyond it is the opposite of the cell's own.
fn neighbours(at: u32, c: vec3u) -> vec2f {
    let stride = vec3u(1u, level.cells.x, level.cells.x * level.cells.y);
    let low = c == vec3u(0u);
    let high = c + 1u == level.cells;
    let before = at - select(stride, vec3u(0u), low);
    let after = at + select(stride, vec3u(0u), high);
    var sum = select(vec3f(pressure[before.x], pressure[before.y], pressure[before.z]), vec3f(0.0), low);
    sum += select(vec3f(pressure[after.x], pressure[after.y], pressure[after.z]), vec3f(0.0), high);
    return vec2f(sum.x + sum.y + sum.z, weight_of(low, high));
}

// How often a cell's own pressure is taken from its neighbours', where it lies at low or high walls.
fn weight_of(low: vec3<bool>, high: vec3<bool>) -> f32 {
    let bits = vec3u(level.open) >> vec3u(0u, 2u, 4u);
    let at_low = select(vec3f(0.0), vec3f(2.0), (bits & vec3u(1u)) != vec3u(0u));
    let at_high = select(vec3f(0.0), vec3f(2.0), (bits & vec3u(2u)) != vec3u(0u));
    let own = select(vec3f(1.0), at_low, low) + select(vec3f(1.0), at_high, high);
    return own.x + own.y + own.z;
}
