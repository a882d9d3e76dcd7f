//! How air flows.

use std::f32::consts::TAU;

use glam::Vec3;

use super::{air_of, divergence, heat_now, root_mean_square, set_velocity, velocity_after};
use crate::{
    gpu::read_buffer,
    particles::tests::{engine, play_smoke},
};

const OPEN: &str = "walls = { y = [\"open\", \"open\"] }";
const CLOSED: &str =
    "walls = { x = [\"closed\", \"closed\"], y = [\"closed\", \"closed\"], z = [\"closed\", \"closed\"] }";

/// Eddies in a closed box of one metre that turn into each other, by which wall they touch; all of it full of smoke.
/// Gives the error's root mean square, and how much of the eddies is left.
fn taylor_green(cells: u32, viscosity: f32, fps: f32, steps: u32) -> (f64, f64) {
    let engine = engine();
    let keys = format!(
        "solver = \"grid\"\n\
         grid = {{ box = {{ center = [0, 0, 0], size = [1, 1, {}] }}, cells = {cells}, {CLOSED}, \
         confinement = 0, dissipation = 0, viscosity = {viscosity}, residual = 1e-4 }}\n\
         [object.emitter]\nshape = {{ box = {{ center = [0, 0, 0], size = [2, 2, 2] }} }}\nrate = 1\nlife = 0.1\n\
         source = {{ heat = 0 }}\n",
        8.0 / cells as f32
    );
    let mut player = play_smoke(&engine, 1, fps, &keys);
    let wave = |place: Vec3| {
        let (x, y) = (TAU * (place.x + 0.5), TAU * (place.y + 0.5));
        Vec3::new(x.sin() * y.cos(), -x.cos() * y.sin(), 0.0)
    };
    velocity_after(&engine, &mut player, 1);
    set_velocity(&engine, &player, wave);
    let [u, ..] = velocity_after(&engine, &mut player, 1 + steps);
    // Navier and Stokes: exp(-2 ν k² t).
    let left = (-2.0 * viscosity * TAU * TAU * steps as f32 / fps).exp();
    let (mut errors, mut overlap, mut square) = (Vec::new(), 0.0, 0.0);
    for y in 0..cells {
        for x in 0..cells {
            let start = (TAU * x as f32 / cells as f32).sin() * (TAU * (y as f32 + 0.5) / cells as f32).cos();
            errors.push(u.at(x, y, 3) - left * start);
            overlap += f64::from(u.at(x, y, 3) * start);
            square += f64::from(start * start);
        }
    }
    (root_mean_square(&errors), overlap / square)
}

#[test]
fn taylor_and_greens_eddies_keep_turning_the_better_the_finer() {
    // As far as air goes through two fifths of the box; steps as fine as cells.
    let errors = [16, 32].map(|cells| taylor_green(cells, 0.0, cells as f32 / 0.4, cells).0);
    let order = (errors[0] / errors[1]).log2();
    assert!(errors[1] < 0.03, "off by {errors:?}");
    // Carrying and projecting in turn is of first order in time.
    assert!((0.7..1.3).contains(&order), "of order {order}");
}

#[test]
fn taylor_and_greens_eddies_decay_as_viscosity_says() {
    let (_, left) = taylor_green(32, 0.05, 160.0, 64);
    let rate = -left.ln() / 0.4;
    let exact = 2.0 * 0.05 * f64::from(TAU * TAU);
    assert!((rate / exact - 1.0).abs() < 0.06, "{rate} a second, and not {exact}");
}

const PLUME: &str = "solver = \"grid\"\n\
    force = [{ kind = \"buoyancy\", acceleration = 2, cooling = 0.3 }]\n\
    [object.emitter]\nshape = { sphere = { center = [0, 0.15, 0], radius = 0.1 } }\nrate = 100\nlife = 4\n";

fn plume(grid: &str) -> String {
    PLUME.replace(
        "force",
        &format!("grid = {{ box = {{ center = [0, 0.5, 0], size = [0.5, 1, 0.5] }}, {grid} }}\nforce"),
    )
}

#[test]
fn no_more_divergence_is_left_than_stated() {
    for (residual, walls) in [(0.02, OPEN), (0.001, OPEN), (0.02, CLOSED)] {
        let engine = engine();
        let keys = plume(&format!("cells = 32, {walls}, residual = {residual}"));
        let mut player = play_smoke(&engine, 1, 24.0, &keys);
        let after = root_mean_square(&divergence(&velocity_after(&engine, &mut player, 12)));
        let air = air_of(&player);
        let wanted: Vec<f32> = read_buffer(engine.gpu(), &air.levels.wanted).expect("the device lives");
        let before = root_mean_square(&wanted[..air.plan.cell_count() as usize]);
        assert!(before > 1e-3, "there is something to take away: {before}");
        assert!(after < residual * before, "{after} of {before}; {walls}");
    }
}

#[test]
fn still_air_stays_still() {
    let engine = engine();
    let keys = plume("cells = 16").replace("acceleration = 2", "acceleration = 0");
    let velocity = velocity_after(&engine, &mut play_smoke(&engine, 1, 24.0, &keys), 20);
    assert!(velocity.iter().all(|field| field.values.iter().all(|&speed| speed == 0.0)));
}

#[test]
fn pressure_bears_the_weight_of_smoke_that_fills_a_closed_box() {
    let engine = engine();
    let keys = "solver = \"grid\"\n\
        grid = { box = { center = [0, 0, 0], size = [1, 1, 1] }, cells = 16, walls = { x = [\"closed\", \"closed\"], y = [\"closed\", \"closed\"], z = [\"closed\", \"closed\"] } }\n\
        force = [{ kind = \"gravity\" }]\n\
        [object.emitter]\nshape = { box = { center = [0, 0, 0], size = [2, 2, 2] } }\nrate = 1\n";
    let velocity = velocity_after(&engine, &mut play_smoke(&engine, 1, 24.0, keys), 24);
    let fastest = velocity.iter().flat_map(|field| &field.values).fold(0.0_f32, |most, v| most.max(v.abs()));
    assert!(fastest < 1e-3, "air falls at {fastest} m/s");
}

#[test]
fn a_plume_rises_straight() {
    let engine = engine();
    let mut player = play_smoke(&engine, 1, 24.0, &plume("cells = 32, residual = 1e-5, confinement = 0"));
    let [u, v, w] = velocity_after(&engine, &mut player, 16);
    let fastest = v.values.iter().fold(0.0_f32, |most, &v| most.max(v));
    assert!((0.3..1.5).contains(&fastest), "it rises at {fastest} m/s");
    let cells = u.extent - 1;
    for z in 0..cells.z {
        for y in 0..cells.y {
            for x in 0..cells.x {
                let mirrored = v.at(cells.x - 1 - x, y, z);
                let (leans, turns) = (v.at(x, y, z) - mirrored, u.at(x, y, z) - w.at(z, y, x));
                assert!(leans.abs() < 0.02 * fastest, "{leans} m/s to one side at {x}, {y}, {z}");
                assert!(turns.abs() < 0.02 * fastest, "{turns} m/s round the axis at {x}, {y}, {z}");
            }
        }
    }
    let heat = heat_now(&engine, &player, 0);
    assert!(heat.values.iter().all(|&heat| (0.0..=1.0).contains(&heat)), "nothing is hotter than its source");
}

#[test]
fn wind_blows_through_open_walls_and_gusts_at_once() {
    let engine = engine();
    let keys = plume("cells = 16").replace(
        "acceleration = 2, cooling = 0.3 }",
        "acceleration = 0 }, { kind = \"wind\", velocity = [2, 0, -1], gust = 0.4, gust_secs = 1 }",
    );
    let mut player = play_smoke(&engine, 1, 24.0, &keys);
    let mut speeds = Vec::new();
    for step in [1, 7, 19] {
        let [u, v, w] = velocity_after(&engine, &mut player, step);
        let first = u.at(3, 3, 3);
        speeds.push(first);
        assert!((1.1..2.9).contains(&first), "at {first} m/s");
        let cells = u.extent - 1;
        for x in 0..cells.x {
            assert!((u.at(x, 7, 5) - first).abs() < 2e-3, "{} at {x}, and {first} elsewhere", u.at(x, 7, 5));
            assert!((w.at(x, 7, 5) + 0.5 * first).abs() < 2e-3 && v.at(x, 7, 5).abs() < 2e-3);
        }
    }
    assert!((speeds[0] - speeds[1]).abs() > 0.1, "it gusts: {speeds:?}");
}

#[test]
fn what_appears_in_a_source_flows_out() {
    let engine = engine();
    let keys = "solver = \"grid\"\n\
        grid = { box = { center = [0, 0, 0], size = [1, 1, 1] }, cells = 16, residual = 1e-4, \
        walls = { y = [\"closed\", \"open\"] } }\n\
        [object.emitter]\nshape = { box = { center = [0, 0, 0], size = [0.5, 0.5, 0.5] } }\nrate = 1\n\
        source = { heat = 0, expansion = 3 }\n";
    let mut player = play_smoke(&engine, 1, 24.0, keys);
    let all: f32 = divergence(&velocity_after(&engine, &mut player, 3)).iter().sum();
    // The 8³ cells in the box; those beside it share their middles with nothing.
    let per_cell = 3.0 / 16.0;
    let inside = 512.0 * per_cell;
    assert!(all > inside * 0.99 && all < inside * 2.0, "{all} cells' faces a second, and {inside} inside");
}

#[test]
fn confinement_and_eddies_make_air_turn_more() {
    let turning = |grid: &str| {
        let engine = engine();
        let mut player = play_smoke(&engine, 1, 24.0, &plume(grid));
        let [u, v, _] = velocity_after(&engine, &mut player, 24);
        let cells = u.extent - 1;
        let mut sum = 0.0;
        for z in 0..cells.z {
            for y in 1..cells.y {
                for x in 1..cells.x {
                    let curl = v.at(x, y, z) - v.at(x - 1, y, z) - u.at(x, y, z) + u.at(x, y - 1, z);
                    sum += f64::from(curl * curl);
                }
            }
        }
        sum
    };
    let plain = turning("cells = 32, confinement = 0");
    let confined = turning("cells = 32, confinement = 4");
    let eddying =
        turning("cells = 32, confinement = 0, eddies = { count = 30, radius = 0.12, strength = 4 }");
    assert!(confined > 1.05 * plain, "{confined} and {plain}");
    assert!(eddying > 1.05 * plain, "{eddying} and {plain}");
    // As many in the same place push as much more: none is left out.
    let crowd = |count: u32| {
        turning(&format!(
            "cells = 32, confinement = 0, eddies = {{ count = {count}, radius = 0.3, strength = 1 }}"
        ))
    };
    let (some, many) = (crowd(75), crowd(300));
    assert!(many > 1.5 * some, "{many} and {some}");
}
