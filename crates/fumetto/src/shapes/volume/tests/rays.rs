//! What is left of a ray behind matter whose density is known.

use super::{AWAY, SIDE, Soft, seen, seen_in};
use crate::gpu::Region;

/// Metres by which the ray through each pixel misses the origin.
fn misses() -> impl Iterator<Item = f64> {
    let middle = f64::from(SIDE) / 2.0;
    (0..SIDE * SIDE).map(move |index| {
        let [x, y] = [index % SIDE, index / SIDE].map(|px| (f64::from(px) + 0.5 - middle) / f64::from(SIDE));
        let sine = (x.hypot(y)).atan().sin();
        f64::from(AWAY) * sine
    })
}

/// How far the opacity is from that of `optical`, given how far a ray misses the middle: the mean, and the most.
fn errors(soft: &Soft, optical: impl Fn(f64) -> f64) -> [f64; 2] {
    let error =
        |(texel, miss): (&[f32; 4], f64)| (f64::from(texel[3]) - (1.0 - (-optical(miss)).exp())).abs();
    let errors: Vec<f64> = soft.iter().zip(misses()).map(error).collect();
    [errors.iter().sum::<f64>() / errors.len() as f64, errors.iter().fold(0.0, |a, &b| a.max(b))]
}

const EXTINCTION: f64 = 1.5;

/// Through a ball of radius 1.
fn homogeneous(miss: f64) -> f64 {
    EXTINCTION * 2.0 * (1.0 - miss * miss).max(0.0).sqrt()
}

fn ball(volume: &str) -> Soft {
    seen("{ center = [0, 0, 0], radius = 1 }", &format!("extinction = {EXTINCTION}, glow = 1, {volume}"))
}

#[test]
fn a_homogeneous_ball_takes_light_by_the_length_of_the_chord() {
    let errors = [32, 64, 128].map(|cells| errors(&ball(&format!("cells = {cells}")), homogeneous));
    for ([mean, most], cells) in errors.iter().zip([32.0, 64.0, 128.0]) {
        // A ray that grazes the ball is the worst: a cell more or less of it is a long way.
        let cell_m = 2.0 / cells;
        assert!(*mean < 0.3 * EXTINCTION * cell_m, "{mean} on average with {cells} cells");
        assert!(*most < EXTINCTION * (3.0 * cell_m).sqrt(), "{most} at most with {cells} cells");
    }
    for pair in errors.windows(2) {
        assert!(pair[0][0] / pair[1][0] > 1.7, "{errors:?} should halve with the cells at least");
    }
}

#[test]
fn steps_converge_by_their_square() {
    let soft = |step: f32| ball(&format!("cells = 64, profile = \"linear\", step = {step}"));
    let exact = soft(0.002);
    let error = |step: f32| {
        let squares = soft(step).iter().zip(&exact).map(|(a, b)| (a[3] - b[3]).powi(2)).sum::<f32>();
        squares.sqrt()
    };
    let [coarse, fine] = [error(0.2), error(0.1)];
    assert!(coarse / fine > 2.8, "{coarse} and {fine}");
}

/// A soft ball whose lines of sight each stand for a square of pixels.
fn in_squares(pixels: u32) -> String {
    format!("extinction = {EXTINCTION}, cells = 64, profile = \"linear\", pixels = {pixels}")
}

const SOFT_BALL: &str = "{ center = [0, 0, 0], radius = 1 }";

#[test]
fn what_is_soft_is_blended_between_squares_of_pixels() {
    let each = seen(SOFT_BALL, &in_squares(1));
    for pixels in [2, 3] {
        let errors: Vec<f32> = seen(SOFT_BALL, &in_squares(pixels))
            .iter()
            .zip(&each)
            .map(|(a, b)| (a[3] - b[3]).abs())
            .collect();
        let mean = errors.iter().sum::<f32>() / errors.len() as f32;
        let most = errors.iter().copied().fold(0.0, f32::max);
        assert!(mean < 0.003, "{mean} on average with squares of {pixels}");
        assert!(most < 0.05, "{most} at most with squares of {pixels}");
    }
}

#[test]
fn parts_of_a_picture_share_its_squares_of_pixels() {
    let whole = seen(SOFT_BALL, &in_squares(3));
    let part = Region { picture: [SIDE; 2], first: [13, 20], size: [31, 17] };
    let seen = seen_in(part, SOFT_BALL, &in_squares(3));
    for (index, texel) in seen.iter().enumerate() {
        let [x, y] = [index as u32 % part.size[0], index as u32 / part.size[0]];
        let expected = whole[((part.first[1] + y) * SIDE + part.first[0] + x) as usize];
        // They are rounded elsewhere.
        let apart = (texel[3] - expected[3]).abs();
        assert!(apart < 1e-3, "{texel:?} and {expected:?} at {x}, {y} of the part");
    }
}

#[test]
fn density_that_falls_linearly_adds_up_to_its_closed_form() {
    // The integral of 1 - sqrt(b² + s²) over the chord.
    let linear = |miss: f64| {
        let half = (1.0 - miss * miss).max(0.0).sqrt();
        EXTINCTION * (half - miss * miss * (half / miss.max(1e-9)).asinh())
    };
    let [mean, most] = errors(&ball("cells = 128, profile = \"linear\""), linear);
    assert!(mean < 1e-3 && most < 5e-3, "{mean} on average, {most} at most");
}

#[test]
fn matter_has_the_colour_that_was_picked() {
    let soft = ball("colours = [[0.2, 0.4, 0.8]]");
    let middle = soft[(SIDE * SIDE / 2 + SIDE / 2) as usize];
    for (channel, wanted) in middle.iter().zip([0.2, 0.4, 0.8, 1.0]) {
        assert!((channel / middle[3] - wanted).abs() < 2e-3, "{middle:?}");
    }
}

#[test]
fn puffs_look_the_same_in_either_order() {
    let one = "{ center = [-0.3, 0.1, 0.2], radius = 0.8 }";
    let other = "{ center = [0.4, 0, -0.2], radius = 0.7, mass = 2 }";
    let [there, back] =
        [[one, other], [other, one]].map(|list| seen(&list.join(", "), "glow = 1, cells = 48"));
    assert!(there.iter().any(|texel| texel[3] > 0.9), "there is something");
    assert!(there == back, "they are added up");
}
