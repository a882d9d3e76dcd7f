//! Cells as large as they appear on the picture.

use fumetto_scene::{Noise, Particle, Resolution};
use glam::Vec3;

use super::{
    BENCH, Frame, PoisonError, ROOM, Recipe, Spacing, UNFADED, Workspace, meshes, particle, puffs,
    read_buffer, recipe, reserved,
};
use crate::shapes::surface::{Sight, sight::Balls};

/// A picture of 90 degrees and cells of which 60 lie along its height.
const SHARE: f32 = 1.0 / 60.0;
const HEIGHT_M: f32 = 2.0;
const MOST: f32 = 120.0;

fn seen_from(eye: Vec3) -> Recipe {
    Recipe {
        spacing: Spacing::Picture { share: SHARE, most: MOST },
        sight: Some(Sight { eye, height_m: HEIGHT_M }),
        ..recipe(TWO.len(), 0.05, 0.0)
    }
}

/// 4 m along x.
const TWO: [Particle; 2] = [
    Particle { center: [-1.0, 0.0, 0.0], radius: 1.0, mass: 1.0 },
    Particle { center: [1.0, 0.0, 0.0], radius: 1.0, mass: 1.0 },
];

/// The side of a cell that the device chooses.
fn cell_m(particles: &[Particle], recipe: &Recipe) -> f32 {
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let work = Workspace::new(&bench.gpu, ROOM);
    let mesh = meshes(&bench.gpu, ROOM);
    let mut frame = Frame::new(&bench.gpu, &bench.pool, "test");
    let puffs = puffs(&bench.gpu, particles, UNFADED);
    bench.surface.record(&mut frame, &puffs, recipe, (ROOM, &work), (0.0, reserved(&mesh)));
    frame.submit();
    let lattice: Vec<u32> = read_buffer(&bench.gpu, &work.lattice).expect("the device lives");
    f32::from_bits(lattice[3])
}

/// So far from the nearer ball, to its right.
fn from_the_right(distance_m: f32) -> Vec3 {
    Vec3::new(2.0 + distance_m, 0.0, 0.0)
}

#[test]
fn half_as_far_cells_have_half_the_side() {
    for distance_m in [2.0, 3.3, 5.0] {
        let [near, far] =
            [1.0, 2.0].map(|times| cell_m(&TWO, &seen_from(from_the_right(times * distance_m))));
        assert!((far / near - 2.0).abs() < 1e-4, "{near} m, and {far} m twice as far as {distance_m} m");
        let wanted = SHARE * HEIGHT_M * distance_m;
        assert!((0.9999..1.1894).contains(&(near / wanted)), "{near} m for {wanted} m");
    }
}

#[test]
fn cells_come_in_four_steps_to_an_octave() {
    let mut cells: Vec<f32> = (0..40)
        .map(|step| cell_m(&TWO, &seen_from(from_the_right(2.05 * 2_f32.powf(step as f32 / 40.0)))))
        .collect();
    assert!(cells.is_sorted());
    cells.dedup();
    assert!((4..=5).contains(&cells.len()), "{cells:?}");
    assert!(cells.windows(2).all(|pair| (pair[1] / pair[0] - 1.189_207).abs() < 1e-4), "{cells:?}");
}

#[test]
fn from_within_and_from_far_away_there_are_neither_too_many_nor_too_few() {
    for eye in [Vec3::new(1.0, 0.2, 0.0), from_the_right(1e-3), from_the_right(0.0)] {
        let along = 4.0 / cell_m(&TWO, &seen_from(eye));
        assert!((MOST / 1.1894..=MOST).contains(&along), "{along} cells from {eye}");
    }
    for eye in [from_the_right(1e5), Vec3::splat(1e30)] {
        let along = 4.0 / cell_m(&TWO, &seen_from(eye));
        assert!((8.0 / 1.1894..8.001).contains(&along), "{along} cells from {eye}");
    }
}

#[test]
fn what_is_known_beforehand_is_what_the_device_finds() {
    let noise = Noise { amplitude: 0.0, size_m: 1.0, octaves: 1, seed: 1, drift_m_per_s: [0.0; 3] };
    let surface = fumetto_scene::Surface {
        threshold: 0.05,
        resolution: Resolution::Picture(SHARE),
        size: 1.0,
        noise: Some(noise),
    };
    // What has no mass has no hold, and lies nearest.
    let particles = [&TWO[..], &[particle([9.0, 0.0, 0.0], 3.0, 0.0)]].concat();
    let balls = Balls::new(&surface, 1.0, &particles);
    for eye in [[0.3, 0.2, 0.1], [4.0, 1.0, 3.0], [0.0, 20.0, -7.0], [300.0, 0.0, 0.0]].map(Vec3::from) {
        let recipe = Recipe { puffs: 0..3, ..seen_from(eye) };
        let found = cell_m(&particles, &recipe);
        let Spacing::Cell(known) = balls.spacing(Sight { eye, height_m: HEIGHT_M }, SHARE, MOST) else {
            panic!("the side of a cell is known");
        };
        assert!((known / found - 1.0).abs() < 1e-4, "{known} m, and {found} m on the device, from {eye}");
    }
}
