//! Colours leave exactly as they were picked.

use std::collections::BTreeSet;

use crate::stage::{BACKGROUND, Picture, Rgb, SIDE, Stage, style};

const TONES: [Rgb; 3] = [[0x5f, 0x6b, 0x7d], [0x93, 0xa1, 0xb0], [0xc8, 0xd4, 0xe0]];
const INK: Rgb = [0x10, 0x14, 0x18];

/// Three balls in three tones and ink.
fn picture(antialias: u32) -> Picture {
    let stage = Stage {
        style: style(
            &["#5f6b7d", "#93a1b0", "#c8d4e0"],
            "ink = { on = true, colour = \"#101418\", width = { px = 8 }, offset = 0.2 }",
        ),
        light: "kind = \"sun\", direction = [0.5, -0.6, -1]".into(),
        output: format!("size = [{SIDE}, {SIDE}], antialias = {antialias}"),
        ..Stage::default()
    };
    stage.balls("balls", &[[-1.5, 0.0, 0.0, 3.0], [1.5, 1.0, 0.5, 3.0], [0.5, -1.5, 1.0, 2.5]], "").picture()
}

fn picked() -> BTreeSet<Rgb> {
    TONES.into_iter().chain([INK, BACKGROUND]).collect()
}

#[test]
fn hard_edges_show_the_picked_colours_and_no_others() {
    assert_eq!(picture(1).colours(), picked());
}

#[test]
fn soft_edges_leave_the_picked_colours_between_them() {
    let (hard, soft) = (picture(1), picture(3));
    let mut flat = BTreeSet::new();
    for (x, y) in hard.places().filter(|&(x, y)| (2..SIDE - 2).contains(&x) && (2..SIDE - 2).contains(&y)) {
        let colour = hard.rgb(x, y);
        let around = (0..25).map(|i| hard.rgb(x + i % 5 - 2, y + i / 5 - 2));
        if around.into_iter().all(|other| other == colour) {
            assert_eq!(soft.rgba(x, y), [colour[0], colour[1], colour[2], 255], "at {x}, {y}");
            flat.insert(colour);
        }
    }
    assert_eq!(flat, picked());
    assert!(soft.colours().len() > 20, "edges are soft");
}

#[test]
fn every_grey_survives_averaging() {
    let greys: Vec<_> = (0..=255_u8).map(|grey| format!("#{grey:02x}{grey:02x}{grey:02x}")).collect();
    let mut found = BTreeSet::new();
    for tones in greys.chunks(32) {
        let tones: Vec<_> = tones.iter().map(String::as_str).collect();
        let stage = Stage {
            style: style(&tones, ""),
            // From the side: every tone has a strip of some pixels.
            light: "kind = \"sun\", direction = [-1, 0, 0]".into(),
            output: "size = [256, 256], antialias = 2".into(),
            ..Stage::default()
        };
        let picture = stage.balls("ball", &[[0.0, 0.0, 0.0, 6.0]], "").picture();
        found.extend(picture.colours());
    }
    let missing: Vec<_> = (0..=255_u8).filter(|&grey| !found.contains(&[grey; 3])).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn a_background_image_and_a_ramp_image_keep_their_bytes() {
    let image = |pixels: &[[u8; 4]]| {
        let image = fumetto_formats::Image { width: pixels.len() as u32, height: 1, pixels: pixels.concat() };
        let mut bytes = Vec::new();
        fumetto_formats::write_png(&image, &mut bytes).unwrap();
        bytes
    };
    let files = crate::stage::Files::default()
        .with("sky.png", image(&[[0x35, 0x79, 0xab, 255]]))
        .with("ramp.png", image(&[[0x11, 0x22, 0x33, 255], [0xc8, 0xd4, 0xe0, 255]]));
    let stage = Stage {
        background: "background = { image = \"sky.png\" }".into(),
        style: style(&[], "").replace("tones = []", "ramp = \"ramp.png\""),
        ..Stage::default()
    };
    let mut engine = crate::stage::engine();
    let stage = stage.balls("ball", &[[0.0, 0.0, 0.0, 3.0]], "");
    let mut player = stage.play(&engine, files).unwrap();
    let picture = crate::stage::picture_at(&mut engine, &mut player, 0).unwrap();
    assert_eq!(
        picture.colours(),
        BTreeSet::from([[0x35, 0x79, 0xab], [0x11, 0x22, 0x33], [0xc8, 0xd4, 0xe0]])
    );
}
