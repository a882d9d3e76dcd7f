//! Lines by the angle of surfaces, by shells and out of the picture.

use std::f32::consts::PI;

use crate::{
    models::{ball, boxes, grid},
    stage::{BACKGROUND, CORE, DISTANCE, Files, PX_PER_METRE, Picture, Rgb, SIDE, Stage, style},
};

pub(crate) const INK: Rgb = [0x10, 0x10, 0x18];

pub(crate) fn inked(method: &str, ink: &str) -> Stage {
    let ink = format!(
        "ink = {{ on = true, method = \"{method}\", colour = \"#101018\", lit_thinning = 0, shortest = 0, {ink} }}"
    );
    Stage { style: style(&["#ffffff"], &ink), ..Stage::default() }
}

fn draw(stage: Stage, model: &str, more: &str) -> Picture {
    stage.mesh("model", "model.obj", more).picture_with(Files::default().with("model.obj", model))
}

/// Pixels that the background reaches from the corner of the picture without crossing ink.
fn outside(picture: &Picture) -> Vec<bool> {
    let mut reached = vec![false; (SIDE * SIDE) as usize];
    let mut waiting = vec![(0, 0)];
    while let Some((x, y)) = waiting.pop() {
        if x < SIDE && y < SIDE && !reached[(y * SIDE + x) as usize] && picture.rgb(x, y) != INK {
            reached[(y * SIDE + x) as usize] = true;
            waiting.extend([(x + 1, y), (x.wrapping_sub(1), y), (x, y + 1), (x, y.wrapping_sub(1))]);
        }
    }
    reached
}

#[track_caller]
pub(crate) fn assert_closed(picture: &Picture) {
    let outside = outside(picture);
    let leak =
        picture.places().find(|&(x, y)| outside[(y * SIDE + x) as usize] && picture.rgb(x, y) != BACKGROUND);
    assert_eq!(leak, None, "the line lets the background in");
}

/// Asserts that ink makes a closed ring between two radii on average, to `tolerance` pixels of its width.
#[track_caller]
pub(crate) fn assert_ring(picture: &Picture, [inner, outer]: [f32; 2], tolerance: f32) {
    assert_closed(picture);
    let ink = picture.count(INK) as f32;
    let width = ink / (PI * (inner + outer));
    assert!((width - (outer - inner)).abs() < tolerance, "{width} wide, should be {}", outer - inner);
}

/// Radius of a ball of `radius` metres in the picture: seen at a distance it shows a cone.
pub(crate) fn silhouette(radius: f32) -> f32 {
    PX_PER_METRE * DISTANCE * (radius / DISTANCE).asin().tan()
}

#[test]
fn image_lines_run_along_the_middle_of_a_silhouette() {
    let radius = silhouette(3.0);
    for width in [1.0, 2.0, 3.0, 5.0, 8.0, 13.0, 40.0] {
        let picture = draw(inked("image", &format!("width = {{ px = {width} }}")), &ball(3.0, 48), "");
        assert_ring(&picture, [radius - 0.5 * width, radius + 0.5 * width], 0.08 * width + 0.2);
    }
}

#[test]
fn image_lines_run_round_puffs() {
    let radius = CORE * 3.0 * PX_PER_METRE;
    for width in [3.0, 8.0] {
        let stage = inked("image", &format!("width = {{ px = {width} }}"));
        let picture = stage.balls("ball", &[[0.0, 0.0, 0.0, 3.0]], "").picture();
        assert_ring(&picture, [radius - 0.5 * width, radius + 0.5 * width], 0.08 * width + 0.2);
    }
}

#[test]
fn shells_lie_outside_the_silhouette() {
    let radius = silhouette(3.0);
    for width in [2.0, 5.0, 10.0] {
        let picture = draw(inked("shell", &format!("width = {{ px = {width} }}")), &ball(3.0, 48), "");
        assert_ring(&picture, [radius, radius + width], 0.12 * width + 0.2);
    }
    let picture = draw(inked("shell", "width = { world = 0.2 }"), &ball(3.0, 96), "");
    assert_ring(&picture, [radius, silhouette(3.2)], 0.5);
}

#[test]
fn angles_ink_a_ring_of_known_width() {
    let radius: f32 = 3.0;
    for facing in [0.25, 0.4, 0.6_f32] {
        let picture = draw(inked("angle", &format!("facing = {facing}")), &ball(radius, 64), "");
        // In the triangle of eye, middle and surface the angle at the surface is the normal's, and the law of
        // sines tells that at the eye.
        let at_eye = (radius / DISTANCE * (1.0 - facing * facing).sqrt()).asin();
        let inner = PX_PER_METRE * DISTANCE * at_eye.tan();
        assert_ring(&picture, [inner, silhouette(radius)], 0.6);
    }
}

#[test]
fn angles_ink_the_rims_of_puffs() {
    let picture = inked("angle", "facing = 0.3").balls("ball", &[[0.0, 0.0, 0.0, 3.0]], "").picture();
    let radius = CORE * 3.0 * PX_PER_METRE;
    // A puff's picture is that of a ball from straight before it, but the eye sees its rim at an angle.
    let cosine = |share: f32| {
        let aside = share * CORE * 3.0 / DISTANCE;
        ((1.0 - share * share).sqrt() - share * aside) / aside.hypot(1.0)
    };
    let mut thousandths = (0..1000).map(|step| step as f32 / 1000.0);
    let inner = radius * thousandths.rfind(|&share| cosine(share) >= 0.3).unwrap();
    // The normals of a puff's picture stop a little short of its rim.
    assert_ring(&picture, [inner, radius], 1.5);
}

const CORNER_ON: &str = "transform = { rotation = [33, 41, 12], scale = 2 }";

#[test]
fn the_corners_of_a_shell_meet() {
    for width in [1.5, 4.0, 12.0] {
        let picture =
            draw(inked("shell", &format!("width = {{ px = {width} }}")), &boxes(&[[0.0; 3]]), CORNER_ON);
        assert_closed(&picture);
    }
}

#[test]
fn shells_run_round_the_ends_of_open_surfaces() {
    for rotation in ["[20, 30, 0]", "[20, 210, 0]"] {
        let turned = format!("transform = {{ rotation = {rotation} }}");
        let picture = draw(inked("shell", "width = { px = 4 }"), &grid(2.0, 4), &turned);
        assert_closed(&picture);
        let bare = draw(Stage::default(), &grid(2.0, 4), &turned);
        let on_it =
            picture.places().filter(|&(x, y)| picture.rgb(x, y) == INK && bare.rgb(x, y) != BACKGROUND);
        assert!(on_it.count() < 100, "the surface itself is not inked");
    }
}

#[test]
fn a_floor_seen_at_a_low_angle_has_no_lines() {
    // 3 degrees between the ground and the ray through its middle, in many triangles.
    let flat = "transform = { rotation = [-90, 0, 0], position = [0, -0.5, 0] }";
    let picture = draw(inked("image", "width = { px = 2 }"), &grid(9.0, 60), flat);
    let ground = draw(Stage::default(), &grid(9.0, 60), flat).drawn();
    let ink = picture.count(INK);
    // One line round it: as long as the ground is wide in front, and its two sides.
    assert!(ground > 10_000 && ink < 2 * 2 * SIDE as usize, "{ink} pixels of ink on {ground} of ground");
    let middle = |&(x, y): &(u32, u32)| x > 100 && x < 400 && y > 290 && y < 500;
    let inside = picture.places().filter(middle).filter(|&(x, y)| picture.rgb(x, y) == INK).count();
    assert_eq!(inside, 0);
}

/// A box that stands corner first out of a plate. Its sides meet the plate at 1.3 m from the middle.
fn box_in_plate(method: &str) -> Picture {
    let stage = inked(method, "width = { px = 3 }")
        .mesh("plate", "box.obj", "transform = { scale = [3.5, 3.5, 0.1] }")
        .mesh("box", "box.obj", "transform = { rotation = [0, 45, 0], scale = [0.99, 2, 0.99] }");
    stage.picture_with(Files::default().with("box.obj", boxes(&[[0.0; 3]])))
}

#[test]
fn shapes_that_run_into_each_other_have_a_line_there() {
    for method in ["image", "hybrid"] {
        let picture = box_in_plate(method);
        let column = |metres: f32| 0.5 * SIDE as f32 + metres * PX_PER_METRE * DISTANCE / (DISTANCE - 0.1);
        let inked_in = |low: f32, high: f32, y: u32| {
            (low as u32..high as u32).filter(|&x| picture.rgb(x, y) == INK).count()
        };
        for y in 180..330 {
            for metres in [-1.3, 1.3] {
                let line = inked_in(column(metres) - 5.0, column(metres) + 6.0, y);
                assert!((2..=4).contains(&line), "{method}: {line} pixels wide at row {y}, {metres} m");
            }
            // The flat faces beside it.
            for [low, high] in [[-1.15, -0.12], [0.12, 1.15], [1.45, 3.2], [-3.2, -1.45]] {
                assert_eq!(inked_in(column(low), column(high), y), 0, "{method}: row {y}, {low} to {high} m");
            }
        }
    }
}

#[test]
fn pieces_of_one_model_that_run_into_each_other_have_a_line_there() {
    // One box stands in another's lid, over 1.1 m of which its front runs.
    let model = boxes(&[[0.0, -1.0, 0.0], [0.9, 0.9, -0.5]]);
    let turned = "transform = { rotation = [25, 0, 0] }";
    for method in ["image", "hybrid"] {
        let picture = draw(inked(method, "width = { px = 3 }"), &model, turned);
        assert!(picture.count(INK) > 150, "{method}: {} pixels", picture.count(INK));
    }
}

#[test]
fn ink_can_be_turned_off() {
    for method in ["angle", "shell", "image", "hybrid"] {
        let stage = inked(method, "").mesh("model", "model.obj", "style = { ink = { on = false } }");
        let picture = stage.picture_with(Files::default().with("model.obj", ball(3.0, 24)));
        assert_eq!(picture.count(INK), 0, "{method}");
    }
}

#[test]
fn what_stands_before_a_line_hides_it() {
    // The wide line of the ball behind stays behind the bare square before it.
    let stage = inked("image", "width = { px = 30 }")
        .mesh("ball", "ball.obj", "transform = { position = [0, 0, -3] }")
        .mesh(
            "square",
            "square.obj",
            "transform = { position = [2.5, 0, 2] }\nstyle = { ink = { on = false } }",
        );
    let files = Files::default().with("ball.obj", ball(3.0, 32)).with("square.obj", grid(1.5, 1));
    let picture = stage.picture_with(files);
    let row = SIDE / 2;
    let left = (0.5 * SIDE as f32 + PX_PER_METRE * DISTANCE * (1.0 / 8.0)) as u32;
    let on_square = (left + 2..left + 100).filter(|&x| picture.rgb(x, row) == INK).count();
    assert_eq!(on_square, 0);
    assert!(picture.count(INK) > 1000);
}
