//! Ramps that have rows.

use std::{collections::BTreeSet, fmt::Write as _};

use crate::{
    models::square,
    shadings::{FROM_CAMERA, ROWS, Spot, assert_share, lit_ball, rows, shaded, stage},
    stage::{BACKGROUND, DISTANCE, Files, PX_PER_METRE, SIDE},
};

#[test]
fn rows_may_run_with_the_facing() {
    for exponent in [1.0, 2.0_f32] {
        let ramp = format!("ramp = {{ image = \"ramp.png\", rows = {{ facing = {exponent} }} }}");
        let picture = lit_ball(shaded(&ramp, ""), FROM_CAMERA);
        let within = |share: f32| Spot::where_is(share, |spot| spot.facing()[0].powf(exponent)).share();
        // The ball's rim gets too little light for the right half of the ramp.
        let lit = Spot::where_is(0.5, |spot| spot.angle.cos()).share();
        assert_share(&picture, ROWS[0][1], within(0.75));
        assert_share(&picture, ROWS[1][1], within(0.5).min(lit) - within(0.75));
        let last = picture.count(ROWS[3][0]) + picture.count(ROWS[3][1]);
        assert!((last as f32 / picture.drawn() as f32 - (1.0 - within(0.25))).abs() < 0.006, "{last}");
    }
}

#[test]
fn rows_may_run_with_the_distance() {
    let style = shaded("ramp = { image = \"ramp.png\", rows = { depth = [6, 16] } }", "");
    let places = [-1.5, -0.5, 0.5, 1.5].map(|x: f32| x * 2.0);
    // The logarithm's quarters between 6 and 16 m end at 7.67, 9.8 and 12.5 m.
    let distances = [7.0, 9.0, 11.0, 14.0];
    let mut copies = String::new();
    for (x, distance) in places.into_iter().zip(distances) {
        let z = DISTANCE - distance;
        write!(copies, "{{ position = [{}, 0, {z}], scale = 0.4 }},", x * distance / DISTANCE).unwrap();
    }
    let stage = stage(style, FROM_CAMERA).mesh("squares", "square.obj", &format!("transform = [{copies}]"));
    let picture =
        stage.picture_with(Files::default().with("square.obj", square(1.0)).with("ramp.png", rows()));
    for (x, row) in places.into_iter().zip(ROWS) {
        assert_eq!(picture.rgb((SIDE as f32 / 2.0 + x * PX_PER_METRE) as u32, SIDE / 2), row[1], "at {x}");
    }
}

#[test]
fn rows_may_run_from_a_focus() {
    let rows_key = "rows = { focus = { center = [1, 0, 0], radius = [0.5, 2.5] } }";
    let style = shaded(&format!("ramp = {{ image = \"ramp.png\", {rows_key} }}"), "");
    let stage = stage(style, FROM_CAMERA).mesh("square", "square.obj", "");
    let picture =
        stage.picture_with(Files::default().with("square.obj", square(4.0)).with("ramp.png", rows()));
    for (row, [inner, outer]) in ROWS.into_iter().zip([[0.0, 1.0], [1.0, 1.5], [1.5, 2.0_f32]]) {
        let area = std::f32::consts::PI * (outer * outer - inner * inner) * PX_PER_METRE.powi(2);
        let share = picture.count(row[1]) as f32 / area;
        assert!((share - 1.0).abs() < 0.02, "{share}");
    }
}

#[test]
fn a_ramp_without_rows_is_its_middle_row() {
    let named = lit_ball(shaded("ramp = \"ramp.png\"", ""), FROM_CAMERA);
    assert_eq!(named.colours(), BTreeSet::from([BACKGROUND, ROWS[2][0], ROWS[2][1]]));
    assert_eq!(lit_ball(shaded("ramp = { image = \"ramp.png\" }", ""), FROM_CAMERA), named);
}
