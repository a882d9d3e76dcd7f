//! One volume, by its closed forms.

use super::{bodies_at, engine, play, vertices_at};

/// A drop of radius 1 that falls at once with half of that.
fn drop(spread: &str) -> String {
    format!("drop = {{ at = [1, 2, 3], radius = 1, start = 0.5 }}\nspread = {{ {spread} }}")
}

/// Radii of the first vertex at the frames up to `last`.
fn radii(spread: &str, last: u32) -> Vec<f32> {
    let engine = engine();
    let mut player = play(&engine, &drop(spread), "");
    (1..=last).map(|frame| vertices_at(&engine, &mut player, frame)[0][0]).collect()
}

#[test]
fn a_free_volume_settles_where_pressure_and_elasticity_are_in_balance() {
    let engine = engine();
    for (stiffness, elasticity) in [(16.0, 0.0), (16.0, 4.0), (9.0, 18.0), (20_000.0, 5000.0)] {
        let spread =
            format!("grain = 0, stiffness = {stiffness}, elasticity = {elasticity}, subdivisions = 4");
        let mut player = play(&engine, &drop(&spread), "");
        let vertices = vertices_at(&engine, &mut player, 240);
        let expected = (stiffness * 1.0 + elasticity * 0.5) / (stiffness + elasticity);
        assert_eq!(vertices.len(), 162);
        for [radius, speed] in vertices {
            assert!((radius - expected).abs() < 1e-5 && speed.abs() < 1e-4, "{radius} should be {expected}");
        }
    }
}

#[test]
fn at_critical_friction_nothing_overshoots_and_below_it_rings() {
    for spread in ["grain = 0", "grain = 0, stiffness = 3000", "grain = 0, friction = 3"] {
        let radii = radii(spread, 120);
        assert!(radii.is_sorted(), "{spread}: {radii:?}");
        assert!(radii[119] <= 1.0 + 1e-6, "{spread}: {}", radii[119]);
    }
    let ringing = radii("grain = 0, friction = 0.2", 120);
    assert!(ringing.iter().any(|radius| *radius > 1.2), "{ringing:?}");
    assert!((ringing[119] - 1.0).abs() < 0.02, "and settles: {}", ringing[119]);
}

#[test]
fn a_step_is_as_a_finer_one() {
    // Critically damped from rest: 1 - 0.5 (1 + ωt) exp(-ωt), with ω = 4.
    let radii = radii("grain = 0", 48);
    for (number, radius) in (1..).zip(&radii) {
        let phase = 4.0 * number as f32 / 24.0;
        let expected = 1.0 - 0.5 * (1.0 + phase) * (-phase).exp();
        assert!((radius - expected).abs() < 0.03, "frame {number}: {radius} should be about {expected}");
    }
}

#[test]
fn more_radius_is_more_volume_in_any_grain() {
    let engine = engine();
    let volumes = [0.3, 0.6, 1.0, 1.1, 2.5].map(|radius| {
        let keys = format!(
            "drop = {{ at = [0, 0, 0], radius = {radius}, start = 0.1 }}\nspread = {{ grain = 0.5, grain_size = 0.4 }}"
        );
        let mut player = play(&engine, &keys, "");
        let vertices = vertices_at(&engine, &mut player, 200);
        vertices.iter().map(|[radius, _]| radius.powi(3)).sum::<f32>() / vertices.len() as f32
    });
    assert!(volumes.is_sorted_by(|less, more| less < more), "{volumes:?}");
}

#[test]
fn grain_moves_a_border_as_far_as_it_says() {
    let engine = engine();
    let mut player = play(&engine, &drop("grain = 0.2, grain_size = 0.3"), "");
    let vertices = vertices_at(&engine, &mut player, 240);
    let (least, largest) =
        vertices.iter().fold((9.0_f32, 0.0_f32), |(least, largest), [r, _]| (least.min(*r), largest.max(*r)));
    assert!((0.8..0.95).contains(&least) && (1.05..1.2).contains(&largest), "{least} to {largest}");
    let body = bodies_at(&engine, &mut player, 240)[0];
    assert_eq!((body.near, body.far), (least, largest), "the volume knows how far it reaches");
}

#[test]
fn paint_runs_until_elasticity_holds_it() {
    let engine = engine();
    let spread = "grain = 0, elasticity = 5, gravity = [0, -2, 0]";
    let mut player = play(&engine, &drop(spread), "");
    let [body] = bodies_at(&engine, &mut player, 480)[..] else { panic!("there is one volume") };
    assert_eq!(body.start, [1.0, 2.0, 3.0]);
    assert!((body.end[1] - (2.0 - 2.0 / 5.0)).abs() < 1e-3, "{:?}", body.end);
    // The sides of the volume run too: each vertex by what of gravity lies along its ray.
    let balance = (16.0 + 0.5 * 5.0) / 21.0;
    assert!((body.far - (balance + 2.0 / 21.0)).abs() < 2e-3, "{} of {balance}", body.far);
    let kept = format!("{}\nkeep = {{ center = [1, 2, 3], size = [4, 0.5, 4] }}", drop(spread));
    let mut player = play(&engine, &kept, "");
    assert_eq!(bodies_at(&engine, &mut player, 480)[0].end, [1.0, 1.75, 3.0], "it stays in its box");
}

#[test]
fn it_grows_and_shrinks_with_time_and_is_not_there_before() {
    let engine = engine();
    let keys = "drop = { at = [0, 0, 0], time = 1, radius = [[0, 1], [3, 1], [4, 0]] }\nspread = { stiffness = 400 }";
    let mut player = play(&engine, keys, "");
    let far = [0, 24, 25, 90, 240].map(|frame| bodies_at(&engine, &mut player, frame)[0].far);
    assert_eq!(far[..2], [0.0, 0.0], "at frame 24 the step from 1 s on is still to come");
    assert!(far[2] > 0.05 && far[3] > 0.9 && far[4] < 1e-3, "{far:?}");
}

#[test]
fn washes_lie_in_each_other() {
    let engine = engine();
    let keys = "drop = { at = [0, 0, 0], radius = 2 }\nspread = { grain = 0 }\n\
                wash = { steps = 3, spacing = 0.25, colour = \"#ff0000\" }";
    let mut player = play(&engine, keys, "");
    let far: Vec<f32> = bodies_at(&engine, &mut player, 240).iter().map(|body| body.far).collect();
    assert!(far.iter().zip([2.0, 1.5, 1.0]).all(|(a, b)| (a - b).abs() < 1e-4), "{far:?}");
}

#[test]
fn whichever_way_time_goes_the_same_bytes_come() {
    let engine = engine();
    let keys = "drop = [{ at = [0, 0, 0], time = 0.7, radius = 2 }, { at = [1, 0, 0], radius = [[0, 1], [2, 3]] }]\n\
                stroke = { path = [[0, 0, 0], [3, 0, 0], [3, 2, 0]], during = [0.2, 1.9], radius = 0.5 }\n\
                spread = { grain = 0.3, gravity = [0, -1, 0], elasticity = 1 }";
    let bytes = |frames: &[u32]| {
        let mut player = play(&engine, keys, "");
        let mut vertices = Vec::new();
        for &frame in frames {
            vertices = vertices_at(&engine, &mut player, frame);
        }
        let bodies = bodies_at(&engine, &mut player, frames[frames.len() - 1]);
        [bytemuck::cast_slice::<_, u8>(&vertices), bytemuck::cast_slice(&bodies)].concat()
    };
    let once = bytes(&[50]);
    assert!(once == bytes(&[50]));
    assert!(once == bytes(&[10, 11, 37, 50]), "stops on the way");
    assert!(once == bytes(&[60, 3, 50]), "back and forth");
    assert!(once != bytes(&[51]));
}
