// Blocks that a particle touches.

// Cells that reaches are widened by: far more than what rounding loses.
const SLACK: f32 = 0.25;

fn first_block(low: vec3f, cell_m: f32) -> vec3f {
    return floor((low / cell_m - SLACK) / f32(BLOCK));
}

fn last_block(high: vec3f, cell_m: f32) -> vec3f {
    return floor((high / cell_m + SLACK) / f32(BLOCK));
}
