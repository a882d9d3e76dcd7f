// Paint that is poured: cells of a grid over the ground, each of which holds some paint and spills what is more into
// neighbours that lie lower, paint included (ten Bosch, section 2: "grid cells that can spill from one to the other").
// A round of it has two passes, of which the first says what each cell gives and the second what it has then: whoever
// comes first, the outcome is the same.

struct Grid {
    // Along x and z.
    columns: u32,
    rows: u32,
    // The corner where the first cell begins.
    corner: vec2f,
    cell: f32,
    // What part of what it has too much a cell gives to each neighbour in one round: a fifth at most, so that it
    // never gives more than it has.
    share: f32,
    // Seconds of a round.
    dt: f32,
    // In metres a second.
    speed: f32,
    pours: u32,
    seed: u32,
    // Of radii, for the volumes that are ordered.
    scale: f32,
    // Metres in which a cell's paint spreads evenly, at most, to one side of its middle.
    jitter: f32,
}

struct Floor {
    height: f32,
    // How deep paint may lie before it spills.
    hold: f32,
}

struct Cell {
    // How deep paint lies.
    depth: f32,
    // How far it has run down from the neighbour that first poured into this cell.
    fallen: f32,
    // 0: dry. 1: wet since this step. 2: wet.
    state: u32,
    // That neighbour, counted from 1, where it lies higher; else 0.
    origin: u32,
}

// Into one cell, how much deeper it gets in a round.
struct Pour {
    cell: u32,
    depth: f32,
}

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var<storage, read> floors: array<Floor>;
@group(0) @binding(2) var<storage, read> pours: array<Pour>;
@group(0) @binding(3) var<storage, read_write> cells: array<Cell>;
// What each cell gives to the neighbours on the right, the left, before and behind.
@group(0) @binding(4) var<storage, read_write> flows: array<vec4f>;
@group(0) @binding(5) var<storage, read_write> orders: array<Order>;

const NOTHING: f32 = -1e30;
const NO_CELL: u32 = 0xffffffffu;
const DRY: u32 = 0u;
const WET_NOW: u32 = 1u;
const WET: u32 = 2u;

// Shares of a cell's side: a volume covers its cell where that is full, and meets its neighbours' where not.
const LEAST_RADIUS: f32 = 0.3;
const FULL_RADIUS: f32 = 0.7;
const FIRST_RADIUS: f32 = 0.1;

// A neighbour that lies higher by more than this share of a cell pours, and does not only run.
const FALL: f32 = 0.5;

fn neighbour(cell: u32, way: u32) -> u32 {
    let at = vec2i(vec2u(cell % grid.columns, cell / grid.columns));
    let next = at + array(vec2i(1, 0), vec2i(-1, 0), vec2i(0, 1), vec2i(0, -1))[way];
    let is_there = all(next >= vec2i(0)) && all(next < vec2i(vec2u(grid.columns, grid.rows)));
    return select(NO_CELL, u32(next.y) * grid.columns + u32(next.x), is_there);
}

fn height_of(cell: u32) -> f32 {
    if cell == NO_CELL {
        return NOTHING;
    }
    return floors[cell].height + cells[cell].depth;
}

@compute @workgroup_size(64)
fn give(@builtin(global_invocation_id) id: vec3u) {
    let cell = id.x;
    if cell >= grid.columns * grid.rows {
        return;
    }
    let excess = max(cells[cell].depth - floors[cell].hold, 0.0);
    var flow = vec4f(0.0);
    for (var way = 0u; way < 4u; way++) {
        let fall = height_of(cell) - height_of(neighbour(cell, way));
        flow[way] = grid.share * clamp(fall, 0.0, excess);
    }
    flows[cell] = flow;
}

@compute @workgroup_size(64)
fn take(@builtin(global_invocation_id) id: vec3u) {
    let number = id.x;
    if number >= grid.columns * grid.rows || floors[number].height == NOTHING {
        return;
    }
    var cell = cells[number];
    let gives = flows[number];
    cell.depth -= gives.x + gives.y + gives.z + gives.w;
    var most = 0.0;
    var origin = 0u;
    for (var way = 0u; way < 4u; way++) {
        let other = neighbour(number, way);
        if other != NO_CELL {
            // What lies to the right gives to the left.
            let gets = flows[other][way ^ 1u];
            cell.depth += gets;
            let is_higher = floors[other].height > floors[number].height + FALL * grid.cell;
            origin = select(origin, way + 1u, is_higher && gets > most);
            most = max(most, gets);
        }
    }
    for (var pour = 0u; pour < grid.pours; pour++) {
        cell.depth += select(0.0, pours[pour].depth, pours[pour].cell == number);
    }
    cell.fallen += select(0.0, grid.speed * grid.dt, cell.state != DRY);
    if cell.state == DRY && cell.depth > 0.0 {
        cell.state = WET_NOW;
        cell.origin = origin;
    }
    cells[number] = cell;
}

@compute @workgroup_size(64)
fn order(@builtin(global_invocation_id) id: vec3u) {
    let number = id.x;
    if number >= grid.columns * grid.rows {
        return;
    }
    let cell = cells[number];
    let floor = floors[number];
    if cell.state == DRY {
        orders[number] = Order(vec3f(0.0), 0.0, vec3f(0.0), 0.0, 0u);
        return;
    }
    let at = vec2f(vec2u(number % grid.columns, number / grid.columns)) + 0.5;
    let aside = (vec2f(random(grid.seed, number), random(grid.seed + 1u, number)) * 2.0 - 1.0) * grid.jitter;
    let flat_place = grid.corner + at * grid.cell + aside;
    let end = vec3f(flat_place.x, floor.height, flat_place.y);
    var start = end;
    var reached = end;
    if cell.origin != 0u {
        // Paint that falls runs down from the edge above.
        let way = array(vec2f(1.0, 0.0), vec2f(-1.0, 0.0), vec2f(0.0, 1.0), vec2f(0.0, -1.0))[cell.origin - 1u];
        let edge = grid.corner + (at + 0.5 * way) * grid.cell;
        start = vec3f(edge.x, floors[neighbour(number, cell.origin - 1u)].height, edge.y);
        let along = end - start;
        reached = start + along * min(cell.fallen / max(length(along), 1e-20), 1.0);
    }
    let full = mix(LEAST_RADIUS, FULL_RADIUS, min(cell.depth / floor.hold, 1.0));
    let desired = grid.scale * grid.cell * full;
    orders[number] = Order(start, desired, reached, grid.scale * grid.cell * FIRST_RADIUS, cell.state);
}

// What is wet is no longer new.
@compute @workgroup_size(64)
fn settle(@builtin(global_invocation_id) id: vec3u) {
    let number = id.x;
    if number < grid.columns * grid.rows && cells[number].state == WET_NOW {
        cells[number].state = WET;
    }
}
