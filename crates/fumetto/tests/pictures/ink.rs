//! Lines: how wide the outline is, and how many inner lines there are.

use std::f32::consts::PI;

use crate::stage::{BACKGROUND, CORE, PX_PER_METRE, Picture, Random, Rgb, Stage, style};

const INK: Rgb = [0x10, 0x10, 0x18];

fn inked(stage: Stage, ink: &str) -> Stage {
    let ink = format!("ink = {{ on = true, colour = \"#101018\", lit_thinning = 0, shortest = 0, {ink} }}");
    Stage { style: style(&["#ffffff"], &ink), ..stage }
}

/// Asserts that a ball's outline is `width` pixels wide, within half a pixel.
#[track_caller]
fn assert_outline(width: f32, ink: &str) {
    let radius = 2.5;
    let picture = inked(Stage::default(), ink).balls("ball", &[[0.0, 0.0, 0.0, radius]], "").picture();
    // A ring around the disc.
    let inner = CORE * radius * PX_PER_METRE;
    let area = PI * ((inner + width).powi(2) - inner.powi(2));
    let ink = picture.count(INK) as f32;
    let half_a_pixel = PI * (inner + width);
    assert!((ink - area).abs() < half_a_pixel, "{ink} pixels of ink {width} wide, should be {area}");
}

#[test]
fn an_outline_is_as_wide_as_said() {
    for width in [3.0, 6.0, 10.0, 16.0] {
        assert_outline(width, &format!("width = {{ px = {width} }}"));
    }
}

#[test]
fn an_outline_may_be_wide_in_metres() {
    assert_outline(0.2 * PX_PER_METRE, "width = { world = 0.2 }");
}

#[test]
fn an_outline_scales_with_the_picture() {
    let share = |side: u32| {
        let stage = inked(Stage::default(), "width = { px = 10 }");
        let stage = Stage { output: format!("size = [{side}, {side}], antialias = 1"), ..stage };
        let picture = stage.balls("ball", &[[0.0, 0.0, 0.0, 2.5]], "").picture();
        picture.count(INK) as f32 / (side * side) as f32
    };
    let (small, large) = (share(300), share(600));
    assert!((small / large - 1.0).abs() < 0.05, "{small} of the small picture is ink, {large} of the large");
}

/// Forty puffs in a heap.
fn heap(ink: &str) -> (Picture, Picture) {
    let mut random = Random(5);
    let mut puff = || {
        let place = [(); 3].map(|()| random.between(-1.8, 1.8));
        [place[0], place[1], place[2], random.between(0.6, 1.2)]
    };
    let puffs: Vec<_> = (0..40).map(|_| puff()).collect();
    let draw = |stage: Stage| stage.cloud("heap", &puffs, "variants = 4", "").picture();
    (draw(inked(Stage::default(), ink)), draw(Stage::default()))
}

/// Ink over the heap, not around it.
fn inner_ink(ink: &str) -> usize {
    let (drawn, plain) = heap(ink);
    let is_inner = |&(x, y): &(u32, u32)| drawn.rgb(x, y) == INK && plain.rgb(x, y) != BACKGROUND;
    drawn.places().filter(is_inner).count()
}

#[test]
fn inner_lines_grow_fewer_with_the_offset() {
    let counts = [0.25, 0.5, 1.0, 2.0, 4.0]
        .map(|offset| inner_ink(&format!("width = {{ px = 4 }}, offset = {offset}")));
    assert!(counts.is_sorted_by(|more, fewer| more > fewer || *more == 0 && *fewer == 0), "{counts:?}");
    assert!(counts[0] > 500 && counts[4] * 20 < counts[0], "{counts:?}");
}

#[test]
fn inner_lines_can_be_left_out() {
    assert_eq!(inner_ink("width = { px = 4 }, offset = 0.25, inner = 0"), 0);
}

#[test]
fn one_contour_runs_round_overlapping_puffs() {
    let (drawn, plain) = heap("width = { px = 4 }, inner = 0");
    let around = drawn.count(INK);
    assert!(around > 1000);
    assert_eq!(around, drawn.drawn() - plain.drawn(), "all ink is around the heap");
}
