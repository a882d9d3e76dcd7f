//! Where light ends on models, by their own shadows.

use crate::{
    mesh_shadows::{LIT, SHADOW, SUN, two_tones},
    models::{ball, square},
    stage::{Files, Stage},
};

/// A round model alone, which looks the same with its shadows and without.
#[track_caller]
fn assert_clean_terminator(light: &str, obj: &str) {
    let picture = |on: bool| {
        let stage = Stage { light: light.into(), style: two_tones(), ..Stage::default() };
        let more = format!("style = {{ shadow = {{ on = {on} }} }}");
        stage.mesh("ball", "ball.obj", &more).picture_with(Files::default().with("ball.obj", obj))
    };
    let (with, without) = (picture(true), picture(false));
    assert!(without.count(SHADOW) > 5000 && without.count(LIT) > 5000, "both sides are seen");
    let apart: Vec<_> = with.places().filter(|&(x, y)| with.rgb(x, y) != without.rgb(x, y)).collect();
    // A facet at the contour may just be seen from behind, in single pixels.
    assert!(apart.len() <= 3, "{} pixels of {} differ, such as {:?}", apart.len(), with.drawn(), apart[0]);
}

#[test]
fn a_coarse_ball_has_a_smooth_terminator() {
    for rings in [5, 8, 40] {
        for light in [
            "kind = \"sun\", direction = [-1, -0.3, -0.2]",
            "kind = \"sun\", direction = [1, -0.1, 0.6]",
            "kind = \"point\", position = [5, 5, 3]",
        ] {
            assert_clean_terminator(light, &ball(3.0, rings));
        }
    }
}

#[test]
fn an_inside_out_ball_has_a_smooth_terminator() {
    let turned: Vec<_> = ball(3.0, 9)
        .lines()
        .map(|line| match line.split(' ').collect::<Vec<_>>()[..] {
            ["f", a, b, c] => format!("f {a} {c} {b}"),
            ["vn", ..] => line.replace(' ', " -").replace("--", ""),
            _ => line.to_owned(),
        })
        .collect();
    assert_clean_terminator("kind = \"sun\", direction = [-1, -0.3, -0.2]", &turned.join("\n"));
}

#[test]
fn an_open_ball_has_a_smooth_terminator() {
    // Without the faces around the pole at the bottom.
    let all = ball(3.0, 12);
    let open: Vec<_> = all.lines().take(all.lines().count() - 24).collect();
    assert_clean_terminator("kind = \"sun\", direction = [-1, -0.1, -0.2]", &open.join("\n"));
}

#[test]
fn a_sheet_with_two_faces_does_not_shadow_itself() {
    // With the same diagonal as the front, and with the other, along which depth is rounded otherwise.
    let sheets = ["f 1/1 4/4 3/3 2/2\n", "f 2/2 1/1 4/4 3/3\n"].map(|back| square(1.0) + back);
    let rotations = [[0, 10, 0], [30, 40, 20], [0, 44, 0], [25, -33, 7]];
    for (sheet, rotation) in sheets.iter().flat_map(|sheet| rotations.map(|rotation| (sheet, rotation))) {
        let transform = format!("transform = {{ position = [-2.5, 0, 2], rotation = {rotation:?} }}");
        let stage = |shadow: bool| {
            let more = format!(
                "{transform}\nstyle = {{ shadow = {{ on = {shadow} }}, tones = [\"#ff0000\", \"#00ff00\"] }}"
            );
            let stage = Stage { light: SUN.into(), style: two_tones(), ..Stage::default() };
            stage
                .mesh("sheet", "sheet.obj", &more)
                .picture_with(Files::default().with("sheet.obj", sheet.clone()))
        };
        assert!(stage(true) == stage(false), "turned by {rotation:?}");
    }
}
