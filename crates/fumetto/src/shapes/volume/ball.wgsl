// A puff as the volume sees it. Uses `recipe` of the program that it is part of.
struct Ball {
    center: vec3f,
    // Zero when there is none.
    radius: f32,
    // Relative to `Recipe.extinction`.
    density: f32,
    // How much of the puff is eaten away from its rim.
    eroded: f32,
    // What makes its noise differ from its neighbours'.
    key: u32,
    colour: vec3f,
}

// Beyond this, in metres and in units of mass, single floats no longer hold squares.
const FARTHEST: f32 = 1e12;
const SMALLEST: f32 = 1e-6;

// Compares bits, for compilers may assume that there is no NaN.
fn is_near(value: f32) -> bool {
    return (bitcast<u32>(value) & 0x7fffffffu) <= bitcast<u32>(FARTHEST);
}

fn ball_of(puff: Puff) -> Ball {
    let fade = puff_fade(puff);
    let density = puff.mass * fade.y;
    let sane = is_near(puff.center.x) && is_near(puff.center.y) && is_near(puff.center.z)
        && is_near(puff.radius) && is_near(density);
    let is_there = sane && puff.radius >= SMALLEST && density >= SMALLEST && fade.x < 1.0;
    let colour = recipe.colours[puff_variant(puff) % recipe.colour_count].rgb;
    return Ball(puff.center, select(0.0, puff.radius, is_there), density, fade.x, puff.look >> 16u, colour);
}

// Distance from the middle within which all its matter is.
fn ball_reach(ball: Ball) -> f32 {
    return ball.radius * (1.0 + recipe.amplitude);
}
