// What a particle touches: cubes of so many cells along their side, which are blocks or regions.

// Cells that reaches are widened by: more than what rounding loses, however far from the origin.
const SLACK: f32 = 0.0625;

fn first_cube(low: vec3f, cell_m: f32, side: i32) -> vec3f {
    return floor((low / cell_m - SLACK) / f32(side));
}

fn last_cube(high: vec3f, cell_m: f32, side: i32) -> vec3f {
    return floor((high / cell_m + SLACK) / f32(side));
}
