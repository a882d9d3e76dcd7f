//! Balls that cover all bricks, for what knows matter as particles.

use std::collections::BTreeSet;

use fumetto_formats::BRICK_SIDE;
use fumetto_scene::Particle;
use glam::{DMat4, DVec3};

use super::MAX_LOBES;

/// One ball for each brick that begins at one of `origins`, or for each cube of bricks, if there are too many.
pub(super) fn cover(world_from_index: DMat4, origins: &[[i32; 3]]) -> Vec<Particle> {
    let mut side = BRICK_SIDE;
    let mut cubes: BTreeSet<[i32; 3]> = origins.iter().copied().collect();
    while cubes.len() > MAX_LOBES as usize {
        side = side.saturating_mul(2);
        cubes = cubes.iter().map(|cube| cube.map(|index| index.div_euclid(side) * side)).collect();
    }
    let side = f64::from(side);
    let corners = [[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, -1.0]];
    let reach =
        |corner: [f64; 3]| world_from_index.transform_vector3(0.5 * side * DVec3::from(corner)).length();
    let radius = corners.map(reach).into_iter().fold(0.0, f64::max) as f32;
    let ball = |cube: &[i32; 3]| {
        let middle = DVec3::from(cube.map(f64::from)) + 0.5 * side;
        let center = world_from_index.transform_point3(middle).as_vec3().to_array();
        Particle { center, radius, mass: 1.0 }
    };
    cubes.iter().map(ball).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_corner_of_every_brick_is_in_a_ball_however_many_there_are() {
        let skewed = DMat4::from_cols_array(&[
            0.5, 0.1, 0.0, 0.0, 0.0, 0.4, 0.2, 0.0, -0.1, 0.0, 0.7, 0.0, 3.0, -4.0, 5.0, 1.0,
        ]);
        for across in [3, 40] {
            let along = || (-across / 2..across / 2).map(|index| 8 * index);
            let plane = |z: i32| along().flat_map(move |y| along().map(move |x| [x, y, z]));
            let origins: Vec<_> = (0..across).flat_map(|z| plane(8 * z)).collect();
            let balls = cover(skewed, &origins);
            assert!(balls.len() <= MAX_LOBES as usize && !balls.is_empty());
            for origin in origins.iter().step_by(97) {
                for corner in 0..8 {
                    let step = [0, 1, 2].map(|axis| f64::from(corner >> axis & 1) * 8.0);
                    let place =
                        skewed.transform_point3(DVec3::from(origin.map(f64::from)) + DVec3::from(step));
                    let holds = |ball: &&Particle| {
                        place.as_vec3().distance(ball.center.into()) <= ball.radius * 1.0001
                    };
                    assert!(balls.iter().any(|ball| holds(&ball)), "{place} is in no ball");
                }
            }
        }
    }
}
