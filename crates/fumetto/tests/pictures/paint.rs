//! Paint that spreads, against closed forms.

use std::{f32::consts::PI, fmt::Write as _};

use fumetto::Shot;

use crate::stage::{Files, PX_PER_METRE, Picture, Rgb, SIDE, Stage, engine, picture_at, style};

/// Faces the camera in the plane z = 0, 16 m wide.
const WALL: &str = "v -8 -8 0\nv 8 -8 0\nv 8 8 0\nv -8 8 0\nf 1 2 3 4\n";

const COLOUR: Rgb = [0xe0, 0x50, 0x20];

/// By when everything has settled.
const SETTLED: u32 = 200;

fn wall(keys: &str) -> Stage {
    let stage = Stage { style: style(&["#e05020"], ""), ..Stage::default() };
    paint(stage.mesh("wall", "wall.obj", ""), keys)
}

/// Adds paint without grain; `keys` come first.
fn paint(mut stage: Stage, keys: &str) -> Stage {
    let grain = if keys.contains("spread") { "" } else { "spread = { grain = 0, stiffness = 100 }" };
    writeln!(stage.objects, "[[object]]\nname = \"paint\"\nkind = \"paint\"\n{grain}\n{keys}").unwrap();
    stage
}

fn settled(stage: &Stage) -> Picture {
    let mut engine = engine();
    let mut player = stage.play(&engine, Files::default().with("wall.obj", WALL)).unwrap();
    picture_at(&mut engine, &mut player, SETTLED).unwrap()
}

/// The grey that is as bright as a colour, in double precision.
fn grey(colour: Rgb) -> Rgb {
    let decoded = |byte: u8| {
        let encoded = f64::from(byte) / 255.0;
        if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
    };
    let light: f64 =
        colour.iter().zip([0.2126, 0.7152, 0.0722]).map(|(byte, weight)| weight * decoded(*byte)).sum();
    let encoded = if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    [(255.0 * encoded).round() as u8; 3]
}

/// Distances of the pixels of one colour from a place, in pixels.
fn reaches(picture: &Picture, colour: Rgb, [x, y]: [f32; 2]) -> Vec<f32> {
    let places = picture.places().filter(|&(x, y)| picture.rgb(x, y) == colour);
    places.map(|(px, py)| (px as f32 + 0.5 - x).hypot(py as f32 + 0.5 - y)).collect()
}

#[test]
fn a_volume_over_a_plane_paints_a_disc() {
    for (height, radius) in [(0.0, 2.0_f32), (0.6, 1.0), (-1.2, 3.0)] {
        let picture = settled(&wall(&format!("drop = {{ at = [0.5, -0.25, {height}], radius = {radius} }}")));
        let middle = [256.0 + 0.5 * PX_PER_METRE, 256.0 + 0.25 * PX_PER_METRE];
        let disc_px = (radius * radius - height * height).sqrt() * PX_PER_METRE;
        let inside = reaches(&picture, COLOUR, middle);
        let farthest = inside.iter().copied().fold(0.0, f32::max);
        assert!((farthest - disc_px).abs() <= 1.0, "{farthest} should be {disc_px}");
        let area = PI * disc_px * disc_px;
        assert!((inside.len() as f32 - area).abs() < 2.0 * disc_px, "{} should be {area}", inside.len());
        let nearest = reaches(&picture, grey(COLOUR), middle).into_iter().fold(1e9, f32::min);
        assert!((nearest - disc_px).abs() <= 1.0, "outside begins where inside ends: {nearest}");
    }
}

#[test]
fn outside_is_as_bright_as_the_coloured_picture_to_the_bit() {
    let tones = ["#203050", "#3f7fb0", "#e0a040", "#f4f0d8", "#c03020"];
    let stage = Stage {
        style: style(&tones, "material = 0, highlight = { colour = \"#ffe8a0\", from = 0.97 }"),
        light: "kind = \"sun\", direction = [-0.6, -0.7, -0.4]".into(),
        background: "background = { gradient = [\"#204060\", \"#c08040\"] }".into(),
        ..Stage::default()
    };
    let balls = [[-2.0, 0.0, 0.0, 2.5], [1.5, 1.0, -1.0, 2.0], [2.0, -2.0, 1.0, 1.5]];
    let stage = stage.balls("balls", &balls, "");
    let coloured = stage.clone().picture();
    let greys = paint(stage, "drop = { at = [0, 0, 0], time = 999, radius = 1 }").picture();
    assert!(coloured.colours().len() > 100, "there is something to see");
    for (x, y) in coloured.places() {
        assert_eq!(greys.rgb(x, y), grey(coloured.rgb(x, y)), "at {x}, {y}");
    }
}

#[test]
fn a_camera_that_comes_through_a_volumes_surface_changes_nothing() {
    let keys = "drop = { at = [0, 0, 0], radius = 8 }";
    for distance in [5.0_f32, 7.5, 7.999, 8.0, 8.001, 8.5, 11.0] {
        // A pixel is as large on the wall from everywhere.
        let fov = 2.0 * (5.0 / distance).atan().to_degrees();
        let camera = format!("eye = [0, 0, {distance}], target = [0, 0, 0], fov = {fov}, near = 0.001");
        let stage = Stage { camera, ..wall(keys) };
        let picture = settled(&stage);
        assert_eq!(picture.count(COLOUR), 512 * 512, "from {distance} m");
        let small = Stage { camera: stage.camera, ..wall("drop = { at = [0, 0, 0], radius = 2 }") };
        let inside = settled(&small).count(COLOUR) as f32;
        let disc = PI * (2.0 * PX_PER_METRE).powi(2);
        assert!((inside - disc).abs() < 300.0, "{inside} of {disc} from {distance} m");
    }
}

#[test]
fn overlapping_volumes_unite_however_many_there_are() {
    let drops = ["{ at = [-1, 0, 0], radius = 2 }", "{ at = [1, 0.5, 0.3], radius = 1.7 }"];
    let spread = "spread = { grain = 0.2, grain_size = 0.5, stiffness = 100 }";
    let draw = |drops: &[&str]| settled(&wall(&format!("drop = [{}]\n{spread}", drops.join(", "))));
    let (both, singles) = (draw(&drops), drops.map(|drop| draw(&[drop])));
    for (x, y) in both.places() {
        let in_any = singles.iter().any(|single| single.rgb(x, y) == COLOUR);
        assert_eq!(both.rgb(x, y) == COLOUR, in_any, "at {x}, {y}");
    }
    let thousand = vec![drops[0]; 1000];
    let thousand = draw(&thousand);
    let differing = thousand.places().filter(|&(x, y)| thousand.rgb(x, y) != singles[0].rgb(x, y)).count();
    assert_eq!(differing, 0, "a thousand in one place are as one");
}

#[test]
fn washes_tint_step_by_step_as_the_formula_says() {
    let decoded = |byte: u8| {
        let encoded = f64::from(byte) / 255.0;
        if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
    };
    let encoded = |light: f64| {
        255.0 * if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
    };
    let tint: Rgb = [0x30, 0x60, 0xc0];
    for (mode, covers) in [("glaze", false), ("cover", true)] {
        let picture = settled(&wall(&format!(
            "drop = {{ at = [0, 0, 0], radius = 4 }}\noutside = \"own\"\n\
             wash = {{ steps = 3, spacing = 0.25, colour = \"#3060c0\", strength = 0.4, mode = \"{mode}\" }}"
        )));
        for (washes, metres) in [(3, 1.0), (2, 2.5), (1, 3.5), (0, 4.5)] {
            let shown = picture.rgb((256.0 + metres * PX_PER_METRE) as u32, 256);
            for channel in 0..3 {
                let (c, t) = (decoded(COLOUR[channel]), decoded(tint[channel]));
                let left = f64::powi(1.0 - 0.4, washes);
                let light = if covers {
                    c * left + t * (1.0 - left)
                } else {
                    c * f64::powi(1.0 - 0.4 + 0.4 * t, washes)
                };
                let expected = encoded(light);
                let apart = (f64::from(shown[channel]) - expected).abs();
                assert!(apart <= 0.75, "{mode} {washes}: {shown:?}, {expected}");
            }
        }
        let rings = picture.colours().len();
        assert_eq!(rings, 4, "three washes and none");
    }
}

#[test]
fn a_border_is_smooth_however_near_it_is_seen() {
    // The coarsest mesh that is worth it, with all the grain that it can carry; 50 times as near as elsewhere.
    let keys = "drop = { at = [0, 0, 0], radius = 2 }\n\
                spread = { subdivisions = 4, grain = 0.15, grain_size = 1.5, stiffness = 100 }";
    let far = settled(&wall(keys));
    let row = |picture: &Picture, x: u32| (0..SIDE).find(|&y| picture.rgb(x, y) == COLOUR);
    for column in [226, 256, 286] {
        let top = row(&far, column).unwrap() as f32;
        let (x, y) = ((column as f32 + 0.5 - 256.0) / PX_PER_METRE, (256.0 - top) / PX_PER_METRE);
        let camera = format!(
            "eye = [{x}, {y}, 10], target = [{x}, {y}, 0], fov = {}",
            2.0 * (0.5_f32 / 50.0).atan().to_degrees()
        );
        let near = settled(&Stage { camera, ..wall(keys) });
        let border: Vec<f32> = (0..SIDE).map(|x| row(&near, x).unwrap_or(0) as f32).collect();
        assert!(border.iter().any(|y| (50.0..462.0).contains(y)), "the border is in the picture");
        // As far as it bends, it does so evenly: in no 64 pixels is it farther than one from a parabola.
        for window in border.windows(64).filter(|w| w.iter().all(|y| (1.0..511.0).contains(y))) {
            let parabola = |t: f32| {
                let (a, b, c) = (window[0], window[32], window[63]);
                let t = t / 63.0;
                let m = 32.0 / 63.0;
                a * (t - m) * (t - 1.0) / m
                    + b * t * (t - 1.0) / (m * (m - 1.0))
                    + c * t * (t - m) / (1.0 - m)
            };
            let off =
                (0_u8..64).map(|t| (window[usize::from(t)] - parabola(t.into())).abs()).fold(0.0, f32::max);
            assert!(off <= 2.0, "{off}");
        }
    }
}

#[test]
fn regions_have_styles_of_their_own() {
    let keys = "drop = { at = [-1, 0, 0], radius = 1.5 }\ninside = { tones = [\"#2040c0\"] }\n\
                outside = { tones = [\"#a0a8a0\"] }";
    let second = "drop = { at = [1, 0, 0], radius = 1.5 }\ninside = \"monochrome\"";
    let stage = paint(wall(keys), &format!("{second}\nspread = {{ grain = 0, stiffness = 100 }}"));
    let stage = Stage { objects: stage.objects.replacen("name = \"paint\"", "name = \"first\"", 1), ..stage };
    let picture = settled(&stage);
    let at = |metres: f32| picture.rgb((256.0 + metres * PX_PER_METRE) as u32, 256);
    assert_eq!(at(-2.0), [0x20, 0x40, 0xc0], "the first paint");
    assert_eq!(at(0.0), grey(COLOUR), "the second lies on the first");
    assert_eq!(at(2.0), grey(COLOUR));
    assert_eq!(at(3.5), [0xa0, 0xa8, 0xa0], "neither");
    assert_eq!(picture.colours().len(), 3);
}

#[test]
fn a_line_runs_along_the_border_with_the_width_that_it_should_have() {
    let keys = "drop = { at = [0, 0, 1], radius = 2.2 }\nborder = { colour = \"#101820\", width = { px = 6 } }\n\
                outside = \"own\"";
    let picture = settled(&wall(keys));
    let disc_px = (2.2_f32 * 2.2 - 1.0).sqrt() * PX_PER_METRE;
    let line = reaches(&picture, [0x10, 0x18, 0x20], [256.0, 256.0]);
    let (least, largest) =
        line.iter().fold((1e9_f32, 0.0_f32), |(least, largest), r| (least.min(*r), largest.max(*r)));
    assert!((disc_px - 3.0 - least).abs() < 1.2, "{least} of {disc_px}");
    assert!((largest - disc_px - 3.0).abs() < 1.2, "{largest} of {disc_px}");
    let area = 2.0 * PI * disc_px * 6.0;
    assert!((line.len() as f32 / area - 1.0).abs() < 0.05, "{} of {area}", line.len());
}

#[test]
fn ink_belongs_to_its_look() {
    let ink = "ink = { on = true, colour = \"#000000\", width = { px = 8 }, inner = 1, lit_thinning = 0, shortest = 0 }";
    let stage = Stage { style: style(&["#e05020"], ink), ..Stage::default() };
    // A small ball before a large one, so that its outline lies on something; the large one's own is farther out.
    let stage = stage.balls("ball", &[[0.0, 0.0, -30.0, 40.0], [0.0, 0.0, 4.0, 3.0]], "");
    let keys = "drop = { at = [200, 0, 0], radius = 200, start = 200 }\nspread = { grain = 0, stiffness = 100 }\n\
                inside = { ink = { on = false } }\noutside = \"own\"";
    let picture = settled(&paint(stage, keys));
    let black = |right: bool| {
        let near = |at: u32| (64..448).contains(&at);
        let on_side =
            |&(x, y): &(u32, u32)| near(x) && near(y) && (x >= 272) == right && !(240..272).contains(&x);
        picture.places().filter(on_side).filter(|&(x, y)| picture.rgb(x, y) == [0; 3]).count()
    };
    assert!(black(false) > 1000, "{}", black(false));
    assert_eq!(black(true), 0, "what covers the right half has no lines");
}

#[test]
fn a_picture_that_is_drawn_by_tiles_shows_no_seams() {
    let keys = "drop = [{ at = [-1, 0, 0.5], radius = 2 }, { at = [2, 1, 0], radius = 1 }]\n\
                spread = { grain = 0.2, stiffness = 100 }\nborder = { colour = \"#000000\", width = { px = 4 } }";
    let stage = wall(keys);
    let mut engine = engine();
    let mut player = stage.play(&engine, Files::default().with("wall.obj", WALL)).unwrap();
    let whole = picture_at(&mut engine, &mut player, SETTLED).unwrap();
    let tiling = fumetto::Tiling { side: 200, most: 0 };
    let shot = Shot::of(player.scene());
    let mut print = engine.print(&player, &shot, tiling).unwrap();
    assert!(print.tile_count() > 4);
    let mut pixels = Vec::new();
    while !print.is_done() {
        if let Some(band) = print.draw_tile(&mut engine, &player).unwrap() {
            pixels.extend(band.pixels);
        }
    }
    assert!(pixels == whole.0.pixels);
}

#[test]
fn paint_stays_in_its_box() {
    let picture = settled(&wall(
        "drop = { at = [0, 0, 0], radius = 3 }\nkeep = { center = [0, 0, 0], size = [2, 9, 9] }",
    ));
    let xs: Vec<u32> =
        picture.places().filter(|&(x, y)| picture.rgb(x, y) == COLOUR).map(|(x, _)| x).collect();
    let (least, largest) = (*xs.iter().min().unwrap() as f32, *xs.iter().max().unwrap() as f32);
    assert!((least - (256.0 - PX_PER_METRE)).abs() <= 1.0, "{least}");
    assert!((largest + 1.0 - (256.0 + PX_PER_METRE)).abs() <= 1.0, "{largest}");
}

#[test]
fn paint_without_anything_to_fall_on_is_told_of() {
    let engine = engine();
    let notes = |keys: &str| {
        let player = wall(keys).play(&engine, Files::default().with("wall.obj", WALL)).unwrap();
        player.notes().to_vec()
    };
    assert_eq!(notes("drop = { at = [0, 0, 1], radius = 2 }"), Vec::<String>::new());
    let far = notes("drop = [{ at = [0, 0, 5], radius = 2 }, { at = [0, 0, 1], radius = 2 }]");
    assert_eq!(far, ["1 of the 2 drops and strokes of `paint` never reach anything that is drawn"]);
    let empty = notes(
        "pour = { at = [0, 0, 0], during = [0, 1], rate = 1 }\n\
         cells = { center = [0, 90, 0], size = [4, 1, 4], cell = 0.5 }",
    );
    assert_eq!(empty.len(), 1, "{empty:?}");
}
