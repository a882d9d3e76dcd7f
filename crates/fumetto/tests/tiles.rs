//! Pictures that are drawn by tiles show what they would show if they were drawn at once.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::{
    fs, io,
    path::{Path, PathBuf},
    sync::{LazyLock, Mutex, PoisonError},
};

use fumetto::{Assets, Engine, Gpu, Player, Shot, Tiling};
use fumetto_formats::Image;
use fumetto_scene::{Scene, SceneText};

/// Building all pipelines takes longer than most tests do: they share one engine.
static ENGINE: LazyLock<Mutex<Engine>> =
    LazyLock::new(|| Mutex::new(Engine::new(pollster::block_on(Gpu::headless()).unwrap())));

/// Tiles as small as the least margins allow: a dozen to each of these pictures.
const SMALL: Tiling = Tiling { side: 1, most: 0 };

/// Share of pixels that may differ: a tile is projected by itself, and what lies within a rounding error of a
/// pixel's middle may fall to either side.
const DIFFERENT: f64 = 4e-5;

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

struct Disk;

impl Assets for Disk {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        fs::read(scenes().join(path))
    }
}

fn play(engine: &Engine, name: &str, frame: u32, set: &[(&str, &str)]) -> Player {
    let toml = fs::read_to_string(scenes().join(format!("{name}.toml"))).unwrap();
    let size = [("output.size", "[480, 270]"), ("output.antialias", "2")];
    let set = size.iter().chain(set).map(|(key, value)| ((*key).to_owned(), (*value).to_owned()));
    let set: Vec<_> = set.collect();
    let text = SceneText { name, toml: &toml, set: &set, style: None };
    let scene = Scene::load(&text, &mut |path| {
        fs::read_to_string(scenes().join(path)).map_err(|error| error.to_string())
    });
    let scene = scene.unwrap_or_else(|report| panic!("{}", report.render(false))).0;
    let mut player = engine.play(scene, Box::new(Disk)).unwrap();
    engine.seek(&mut player, frame).unwrap();
    player
}

fn printed(engine: &mut Engine, player: &Player, shot: &Shot) -> Image {
    let mut print = engine.print(player, shot, SMALL).unwrap();
    assert!(print.tile_count() >= 6, "{} tiles", print.tile_count());
    let mut picture = Image { width: shot.size[0], height: 0, pixels: Vec::new() };
    while !print.is_done() {
        if let Some(band) = print.draw_tile(engine, player).unwrap() {
            assert_eq!(band.width, picture.width);
            picture.height += band.height;
            picture.pixels.extend(band.pixels);
        }
    }
    assert_eq!(print.draw_tile(engine, player).unwrap(), None, "there is no more");
    picture
}

/// Draws both ways.
fn check(name: &str, frame: u32, set: &[(&str, &str)]) {
    check_within(0, name, frame, set);
}

/// Draws both ways; a channel may differ by `most`.
fn check_within(most: u8, name: &str, frame: u32, set: &[(&str, &str)]) {
    let mut engine = ENGINE.lock().unwrap_or_else(PoisonError::into_inner);
    let player = play(&engine, name, frame, set);
    let shot = Shot::of(player.scene());
    let whole = engine.picture(&player, &shot).unwrap();
    let printed = printed(&mut engine, &player, &shot);
    assert_eq!([whole.width, whole.height], [printed.width, printed.height]);
    let places = whole.pixels.chunks(4).zip(printed.pixels.chunks(4)).enumerate();
    let is_apart = |(a, b): (&[u8], &[u8])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > most);
    let differ: Vec<_> =
        places.filter(|(_, pair)| is_apart(*pair)).map(|(i, _)| (i % 480, i / 480)).collect();
    let share = differ.len() as f64 / f64::from(whole.width * whole.height);
    eprintln!("{name}: {} pixels differ, {share:.1e} of all", differ.len());
    assert!(
        share <= DIFFERENT,
        "{name}: {} pixels differ: {:?}",
        differ.len(),
        &differ[..differ.len().min(40)]
    );
}

#[test]
fn puffs() {
    check("cumulus", 0, &[]);
}

#[test]
fn puffs_without_averaging() {
    check("cumulus", 0, &[("output.antialias", "1"), ("output.size", "[960, 540]")]);
}

#[test]
fn a_surface() {
    check("cloud", 0, &[]);
}

#[test]
fn a_surface_with_cells_in_pixels() {
    check("smoke-cel", 60, &[]);
}

#[test]
fn models_and_their_shadows() {
    check("cottage", 150, &[]);
}

#[test]
fn see_through_smoke() {
    check("cottage", 150, &[("object.smoke.opacity", "0.6")]);
}

#[test]
fn all_ways_to_find_lines() {
    for method in ["angle", "shell", "image", "hybrid"] {
        check("cottage", 150, &[("style.ink.method", &format!("{method:?}"))]);
    }
}

#[test]
fn dashes() {
    let dashed = "{ silhouette = { dash = [9, 5] }, hidden = \"dashed\", lit_thinning = 0 }";
    check("edges", 0, &[("style.ink", dashed)]);
}

#[test]
fn strokes() {
    let hatching = "{ wobble = { px = 1 }, tooth = 0.5, spacing = { px = 9 }, follow = \"object\" }";
    // A sample's share of a stroke is a fraction, which may be rounded to either side.
    check_within(1, "cumulus", 0, &[("style.hatching", hatching)]);
    check_within(1, "engraving", 0, &[]);
    let round_it = ("style.hatching", "{ along = \"curvature\", layers = 1 }");
    check_within(1, "cloud", 0, &[round_it, ("output.antialias", "3")]);
}

#[test]
fn pre_shaded_puffs() {
    check("lamp", 96, &[("style.shading", "\"pre-shaded\"")]);
}
