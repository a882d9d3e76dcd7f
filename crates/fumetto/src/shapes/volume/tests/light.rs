//! Light in its grid, against sums over the density as it was read back.

use std::sync::PoisonError;

use glam::{UVec3, Vec3};

use super::{BENCH, Grid, grids, play};

const PARTICLES: &str =
    "{ center = [-0.5, 0, 0], radius = 0.8 }, { center = [0.7, 0.3, -0.2], radius = 0.6 }";
const EXTINCTION: f32 = 2.0;

/// In steps of an eighth of a cell, until far beyond the grid or at the light.
fn brute_force(density: &Grid, place: Vec3, direction: Vec3, until: f32) -> f32 {
    let step_m = density.cell_m / 8.0;
    let inside = |at: Vec3| {
        let cells = (at - density.origin) / density.cell_m;
        cells.cmpge(Vec3::ZERO).all() && cells.cmple(density.cells.as_vec3()).all()
    };
    let places = (0..).map(|step| (step as f32 + 0.5) * step_m).take_while(|&away| away < until);
    let places = places.map(|away| place + direction * away).take_while(|&at| inside(at));
    let optical: f32 = places.map(|at| density.density(at)).sum::<f32>() * step_m * EXTINCTION;
    (-optical).exp()
}

/// The largest and the mean difference over some of the cells of light that lie by matter.
fn differences(lights: &str, toward: impl Fn(Vec3) -> (Vec3, f32), channel: usize) -> [f32; 2] {
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let volume = format!("extinction = {EXTINCTION}, cells = 64, light_cells = 32, edge = 0.3");
    let player = play(&bench, lights, PARTICLES, &volume);
    let [density, light] = grids(bench.engine.gpu(), &player.volumes.volumes[0].field);
    let mut differences = Vec::new();
    for index in (0..light.cells.element_product()).step_by(37) {
        let (x, rest) = (index % light.cells.x, index / light.cells.x);
        let cell = UVec3::new(x, rest % light.cells.y, rest / light.cells.y);
        let place = light.middle(cell);
        // Others are never asked.
        let corners = (0..8).map(|i| 2.0 * UVec3::new(i & 1, i >> 1 & 1, i >> 2).as_vec3() - 1.0);
        if !corners.chain([Vec3::ZERO]).any(|step| density.density(place + light.cell_m * step) > 0.0) {
            continue;
        }
        let (direction, until) = toward(place);
        let expected = brute_force(&density, place, direction, until);
        differences.push((light.texel(cell)[channel] - expected).abs());
    }
    assert!(differences.len() > 100, "only {} cells lie by matter", differences.len());
    let mean = differences.iter().sum::<f32>() / differences.len() as f32;
    [mean, differences.into_iter().fold(0.0, f32::max)]
}

#[test]
fn what_comes_through_from_a_sun_is_what_brute_force_finds() {
    let toward = Vec3::new(-0.6, 1.0, 0.5).normalize_or(Vec3::Y);
    let lights = "{ kind = \"sun\", direction = [0.6, -1, -0.5] }";
    let [mean, most] = differences(lights, |_| (toward, f32::MAX), 0);
    assert!(mean < 4e-3 && most < 0.05, "{mean} on average, {most} at most");
}

#[test]
fn a_point_light_in_the_matter_lights_what_is_around_it() {
    let light = Vec3::new(-0.5, 0.2, 0.0);
    let lights =
        "{ kind = \"sun\", direction = [0, -1, 0] }, { kind = \"point\", position = [-0.5, 0.2, 0] }";
    let toward = |place: Vec3| ((light - place).normalize_or(Vec3::Y), light.distance(place));
    let [mean, most] = differences(lights, toward, 1);
    assert!(mean < 4e-3 && most < 0.05, "{mean} on average, {most} at most");
}

#[test]
fn a_light_without_shadows_comes_through_everything() {
    let lights = "{ kind = \"sun\", direction = [0, -1, 0], shadow = false }";
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let player = play(&bench, lights, PARTICLES, "extinction = 50, cells = 16, light_cells = 8");
    let [_, light] = grids(bench.engine.gpu(), &player.volumes.volumes[0].field);
    assert!(light.texels.iter().all(|&texel| texel == [1.0; 4]));
}
