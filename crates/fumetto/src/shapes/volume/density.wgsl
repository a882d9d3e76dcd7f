// The density of a puff: a ball whose surface noise displaces along its normal, as Tessendorf's pyroclastic
// puffs have it (Normoyle, "Volumetric Clouds"). Uses `recipe` of the program that it is part of.

// Radius of the displaced surface as it is seen from a place, in radii from the middle. Noise is solid: taken in
// the direction alone, all that is fuzzy would look combed.
fn displaced_radius(ball: Ball, off: vec3f) -> f32 {
    if recipe.amplitude == 0.0 {
        return ball.radius;
    }
    let apart = 64.0 * vec3f(random(ball.key, 0u), random(ball.key, 1u), random(ball.key, 2u));
    let at = (off + recipe.drift) * recipe.frequency + apart;
    return ball.radius * max(1.0 + recipe.amplitude * fbm(at, recipe.seed), 0.0);
}

// Density at a place, averaged over a cell where the surface runs through it.
fn ball_density(ball: Ball, place: vec3f, cell_m: f32) -> f32 {
    let off = place - ball.center;
    let away = length(off);
    let rise = recipe.edge * ball.radius;
    // What lies deeper than bumps and the fuzzy edge can reach needs no noise.
    let least = ball.radius * max(1.0 - select(recipe.amplitude, 0.0, recipe.billow != 0u), 0.0);
    let is_deep = recipe.is_linear == 0u && ball.eroded == 0.0 && away + rise + cell_m < least;
    if is_deep {
        return ball.density;
    }
    if away > ball_reach(ball) + cell_m {
        return 0.0;
    }
    // Erosion eats from the rim, deepest where the surface lies lowest.
    let radius = displaced_radius(ball, off / ball.radius) - ball.eroded * ball_reach(ball);
    let inside = clamp((radius - away + 0.5 * cell_m) / (rise + cell_m), 0.0, 1.0);
    let fall = max(1.0 - away / max(radius, 1e-6), 0.0);
    return ball.density * inside * select(1.0, fall, recipe.is_linear != 0u);
}
