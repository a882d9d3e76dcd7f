// A particle among cubes of so many cells along their side, counted in cells.
struct Ball {
    center: vec3f,
    reach: f32,
    side: f32,
    // Cubes in the lattice that its box meets.
    first: vec3i,
    size: vec3i,
}

fn ball_of(grid: Grid, blob: Blob, side: i32) -> Ball {
    if blob.radius == 0.0 {
        return Ball(vec3f(0.0), 0.0, 1.0, vec3i(0), vec3i(0));
    }
    // Regions begin at whole numbers of either cube.
    let low = grid.first * BLOCK / side;
    let high = low + vec3i(grid.regions) * (REGION * BLOCK / side) - 1;
    let first = max(vec3i(first_cube(blob.center - blob.radius, grid.cell_m, side)), low);
    let last = min(vec3i(last_cube(blob.center + blob.radius, grid.cell_m, side)), high);
    let reach = blob.radius / grid.cell_m + SLACK;
    return Ball(blob.center / grid.cell_m, reach, f32(side), first, max(last - first + 1, vec3i(0)));
}

// A row of cubes along x, by its place along y and z from the first. Invocations that share a particle take every
// so many-th row.
struct Row {
    at: vec2i,
    // To the next one, whole layers apart and within a layer: no division is needed on the way.
    step: vec2i,
}

fn first_row(ball: Ball, sharer: u32, sharers: u32) -> Row {
    let rows = max(ball.size.y, 1);
    if sharers == 1u {
        return Row(vec2i(0), vec2i(1, 0));
    }
    let first = i32(sharer);
    let step = i32(sharers);
    return Row(vec2i(first % rows, first / rows), vec2i(step % rows, step / rows));
}

fn next_row(ball: Ball, row: Row) -> Row {
    let at = row.at + row.step;
    return Row(select(at, at + vec2i(-ball.size.y, 1), at.x >= ball.size.y), row.step);
}

// The first and the last cube of a row that the particle touches; the last comes before the first where it touches
// none.
fn touched_in(ball: Ball, row: Row) -> vec2i {
    let low = vec2f(ball.first.yz + row.at) * ball.side;
    let off = ball.center.yz - clamp(ball.center.yz, low, low + ball.side);
    let left = ball.reach * ball.reach - dot(off, off);
    if left < 0.0 {
        return vec2i(1, 0);
    }
    let ends = floor((ball.center.x + sqrt(left) * vec2f(-1.0, 1.0)) / ball.side);
    return clamp(vec2i(ends), vec2i(ball.first.x), vec2i(ball.first.x + ball.size.x - 1));
}
