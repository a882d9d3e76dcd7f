//! Lines along the edges and contours of models.

use std::collections::VecDeque;

use crate::{
    models::{ball, square},
    stage::{BACKGROUND, Files, PX_PER_METRE, Picture, Rgb, SIDE, Stage, style},
};

const INK: Rgb = [0x10, 0x10, 0x18];
const MIDDLE: u32 = SIDE / 2;

const CUBE: &str = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n\
                    f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";

/// White, drawn with vector lines alone.
fn inked(ink: &str) -> Stage {
    let plain = "on = true, method = \"vector\", colour = \"#101018\", lit_thinning = 0, shortest = 0";
    Stage { style: style(&["#ffffff"], &format!("ink = {{ {plain}, {ink} }}")), ..Stage::default() }
}

fn files() -> Files {
    let files = Files::default().with("square.obj", square(2.0)).with("cube.obj", CUBE);
    let files = files.with("ball.obj", ball(4.0, 64)).with("coarse.obj", ball(4.0, 12));
    files.with("small.obj", square(1.0))
}

fn one(model: &str, ink: &str) -> Picture {
    inked(ink).mesh("model", model, "").picture_with(files())
}

/// Pixels of ink along a row.
fn inked_in_row(picture: &Picture, y: u32) -> usize {
    (0..SIDE).filter(|&x| picture.rgb(x, y) == INK).count()
}

#[test]
fn lines_are_as_wide_as_said() {
    for width in [2, 4, 7, 12] {
        let picture = one("square.obj", &format!("width = {{ px = {width} }}"));
        assert_eq!(inked_in_row(&picture, MIDDLE), 2 * width, "two borders, {width} wide");
    }
    let picture = one("square.obj", "width = { world = 0.2 }");
    let expected = 2.0 * 0.2 * PX_PER_METRE;
    let inked = inked_in_row(&picture, MIDDLE) as f32;
    assert!((inked - expected).abs() < 2.0, "{inked} pixels, should be {expected}");
}

#[test]
fn lines_lie_astride_the_edge() {
    let picture = one("square.obj", "width = { px = 8 }");
    let edge = (2.0 * PX_PER_METRE).round() as u32;
    let row: Vec<_> = (MIDDLE..SIDE).filter(|&x| picture.rgb(x, MIDDLE) == INK).collect();
    assert!(row[0].abs_diff(MIDDLE + edge - 4) <= 1 && row.len() == 8, "{row:?}");
}

#[test]
fn each_kind_of_edge_has_its_pen() {
    let pens = "width = { px = 6 }, silhouette = { colour = \"#0000ff\" }, crease = { colour = \"#ff0000\", \
                width = { px = 3 } }, boundary = { on = false }";
    let turned = "transform = { rotation = [35, 45, 0] }";
    let cube = inked(pens).mesh("cube", "cube.obj", turned).picture_with(files());
    let (silhouettes, creases) = (cube.count([0, 0, 255]) as f32, cube.count([255, 0, 0]) as f32);
    // Six edges of twice the width against three, seen a little longer on the outline.
    assert!((3.6..5.0).contains(&(silhouettes / creases)), "{silhouettes} to {creases}");
    assert_eq!(cube.count(INK), 0);
    let square = inked(pens).mesh("square", "square.obj", "").picture_with(files());
    assert_eq!(square.colours().len(), 2, "boundaries are not drawn");
}

#[test]
fn the_silhouette_of_a_ball_is_a_circle() {
    let width = 3.0;
    let picture = one("ball.obj", "width = { px = 3 }");
    // Seen from 10 m a ball of 4 m shows a cone of half angle asin(0.4).
    let radius = PX_PER_METRE * 10.0 * 0.4_f32.asin().tan();
    let from_middle = |x: u32, y: u32| {
        let offset = |at: u32| at as f32 + 0.5 - MIDDLE as f32;
        offset(x).hypot(offset(y))
    };
    for (x, y) in picture.places() {
        let off = (from_middle(x, y) - radius).abs();
        if off < 0.5 * width - 0.5 {
            assert_eq!(picture.rgb(x, y), INK, "at {x}, {y}, {off} off the circle");
        }
        if off > 0.5 * width + 0.5 {
            assert_ne!(picture.rgb(x, y), INK, "at {x}, {y}, {off} off the circle");
        }
    }
}

/// Pixels that are reached from a corner of the picture without crossing ink, not even between pixels that
/// touch at their corners.
fn flooded(picture: &Picture) -> Vec<(u32, u32)> {
    let mut seen = vec![false; (SIDE * SIDE) as usize];
    let mut queue = VecDeque::from([(0, 0)]);
    let mut reached = Vec::new();
    while let Some((x, y)) = queue.pop_front() {
        if std::mem::replace(&mut seen[(y * SIDE + x) as usize], true) || picture.rgb(x, y) == INK {
            continue;
        }
        reached.push((x, y));
        let near = |at: u32| at.saturating_sub(1)..=(at + 1).min(SIDE - 1);
        queue.extend(near(y).flat_map(|y| near(x).map(move |x| (x, y))));
    }
    reached
}

#[test]
fn outlines_are_closed() {
    // The triangles of a coarse ball stand out beside its contour.
    for (model, turn, width) in [
        ("cube.obj", "[35, 45, 0]", 2),
        ("cube.obj", "[20, 10, 5]", 2),
        ("ball.obj", "[0, 0, 0]", 2),
        ("ball.obj", "[50, 20, 0]", 2),
        ("coarse.obj", "[50, 20, 0]", 8),
    ] {
        let stage = inked(&format!("width = {{ px = {width} }}"));
        let more = format!("transform = {{ rotation = {turn} }}");
        let picture = stage.mesh("model", model, &more).picture_with(files());
        let outside = flooded(&picture);
        assert!(outside.len() > 50_000);
        assert!(
            outside.iter().all(|&(x, y)| picture.rgb(x, y) == BACKGROUND),
            "the outline of {model}, turned by {turn}, leaks"
        );
    }
}

/// A small square behind a large one that hides half of it.
fn half_hidden(ink: &str) -> Picture {
    let stage = inked(ink).mesh("front", "square.obj", "transform = { position = [-2, 0, 0.5] }");
    stage.mesh("back", "small.obj", "transform = { scale = 1.5 }").picture_with(files())
}

/// Ink in the middle of the front square.
fn hidden_ink(picture: &Picture) -> usize {
    let in_front = |&(x, y): &(u32, u32)| {
        (MIDDLE - 130..MIDDLE - 20).contains(&x) && y.abs_diff(MIDDLE) < 90 && picture.rgb(x, y) == INK
    };
    picture.places().filter(in_front).count()
}

#[test]
fn hidden_lines_are_gone_or_dashed() {
    assert_eq!(hidden_ink(&half_hidden("width = { px = 4 }")), 0);
    let dashed = hidden_ink(&half_hidden("width = { px = 4 }, hidden = \"dashed\"")) as f32;
    // An upright and two halves of it, drawn for four parts of seven.
    let whole = 4.0 * (2.0 * 1.5 * PX_PER_METRE + 2.0 * 56.0);
    assert!((0.4..0.75).contains(&(dashed / whole)), "{dashed} of {whole} pixels");
}

#[test]
fn dashes_are_as_long_as_said() {
    let whole = one("square.obj", "width = { px = 3 }").count(INK) as f32;
    let dashed = one("square.obj", "width = { px = 3 }, boundary = { dash = [12, 8] }").count(INK) as f32;
    assert!((dashed / whole - 0.6).abs() < 0.06, "{dashed} of {whole} pixels");
}

#[test]
fn smoke_hides_the_lines_behind_it_and_no_others() {
    let draw = |z: f32| {
        let stage = inked("width = { px = 6 }").mesh("square", "square.obj", "");
        let puff = "style = { ink = { on = false }, tones = [\"#ff0000\"] }";
        stage.balls("puff", &[[2.0, 0.0, z, 1.0]], puff).picture_with(files())
    };
    // The puff stands before the middle of the square's right side, then behind it.
    let at = MIDDLE + (2.0 * PX_PER_METRE) as u32;
    assert_eq!(draw(1.0).rgb(at, MIDDLE), [255, 0, 0]);
    assert_eq!(draw(-1.0).rgb(at, MIDDLE), INK);
    assert_eq!(draw(-1.0).rgb(at + 2, MIDDLE), INK, "the outer half covers what is behind");
}

#[test]
fn lines_of_what_stands_before_another_model_are_whole() {
    let stage = inked("width = { px = 8 }").mesh("back", "square.obj", "");
    let picture =
        stage.mesh("front", "small.obj", "transform = { position = [0, 0, 0.5] }").picture_with(files());
    // Two borders of each, 8 wide.
    assert_eq!(inked_in_row(&picture, MIDDLE), 32);
}

#[test]
fn lines_grow_with_the_picture() {
    let share = |side: u32| {
        let stage = Stage {
            output: format!("size = [{side}, {side}], antialias = 1"),
            ..inked("width = { px = 8 }")
        };
        let turned = "transform = { rotation = [35, 45, 0] }";
        let picture = stage.mesh("cube", "cube.obj", turned).picture_with(files());
        picture.count(INK) as f32 / (side * side) as f32
    };
    let (small, large) = (share(300), share(600));
    assert!((small / large - 1.0).abs() < 0.03, "{small} of the small picture is ink, {large} of the large");
}
