//! The scenes in `scenes/` against pictures that somebody has looked at.
//!
//! Pictures are blessed on lavapipe, `UPDATE_GOLDEN=1 cargo test -p fumetto --test golden`, and compared
//! on lavapipe only; elsewhere the tests are skipped, unless `FUMETTO_GOLDEN_REQUIRED` is set, which forbids that.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::{
    env, fs, io,
    path::{Path, PathBuf},
};

use fumetto::{Assets, Engine, Gpu, Shot};
use fumetto_formats::{Image, read_png, write_png};
use fumetto_scene::{Scene, SceneText};

/// A channel may be this much apart: lavapipe compiles for the processor it runs on.
const TOLERANCE: u8 = 8;

/// Share of pixels that may be farther apart.
const DIFFERENT: f64 = 0.005;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

struct Disk(PathBuf);

impl Assets for Disk {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        fs::read(self.0.join(path))
    }
}

fn load(name: &str) -> Scene {
    let scenes = folder("../../scenes");
    let toml = fs::read_to_string(scenes.join(format!("{name}.toml"))).unwrap();
    let set = [("output.size", "[320, 180]"), ("output.antialias", "2")];
    let set = set.map(|(key, value)| (key.to_owned(), value.to_owned()));
    let text = SceneText { name, toml: &toml, set: &set, style: None };
    let mut styles = |path: &str| fs::read_to_string(scenes.join(path)).map_err(|error| error.to_string());
    Scene::load(&text, &mut styles).unwrap_or_else(|report| panic!("{}", report.render(false))).0
}

fn draw(gpu: Gpu, name: &str, frame: u32) -> Image {
    let mut engine = Engine::new(gpu);
    let mut player = engine.play(load(name), Box::new(Disk(folder("../../scenes")))).unwrap();
    engine.seek(&mut player, frame).unwrap();
    let shot = Shot::of(player.scene());
    engine.picture(&player, &shot).unwrap()
}

fn save(image: &Image, path: &Path) {
    write_png(image, fs::File::create(path).unwrap()).unwrap();
}

/// What differs, in white; and the share of it.
fn difference(golden: &Image, actual: &Image) -> (Image, f64) {
    let apart = |(a, b): (&[u8], &[u8])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > TOLERANCE);
    let different: Vec<bool> =
        golden.pixels.chunks_exact(4).zip(actual.pixels.chunks_exact(4)).map(apart).collect();
    let share = different.iter().filter(|&&different| different).count() as f64 / different.len() as f64;
    let pixels = different.iter().flat_map(|&on| if on { [255; 4] } else { [0, 0, 0, 255] }).collect();
    (Image { pixels, ..*golden }, share)
}

/// Why a picture is not as it was, if it is not.
fn complaint(name: &str, golden: &Image, actual: &Image) -> Option<String> {
    if [golden.width, golden.height] != [actual.width, actual.height] {
        return Some(format!("{name} is {} x {} pixels", actual.width, actual.height));
    }
    let (picture, share) = difference(golden, actual);
    if share <= DIFFERENT {
        return None;
    }
    let beside = |kind: &str| folder("tests/golden").join(format!("{name}.{kind}.png"));
    save(actual, &beside("actual"));
    save(&picture, &beside("diff"));
    Some(format!(
        "{:.2} % of {name} differ; see tests/golden/{name}.actual.png and .diff.png beside {name}.png",
        100.0 * share
    ))
}

fn check(name: &str, frame: u32) {
    let gpu = pollster::block_on(Gpu::headless()).unwrap();
    let adapter = gpu.adapter.name.clone();
    if !adapter.contains("llvmpipe") {
        assert!(env::var_os("FUMETTO_GOLDEN_REQUIRED").is_none(), "{adapter} is not lavapipe");
        eprintln!("{name} is skipped: {adapter} is not lavapipe");
        return;
    }
    let actual = draw(gpu, name, frame);
    let path = folder("tests/golden").join(format!("{name}.png"));
    if env::var_os("UPDATE_GOLDEN").is_some() {
        save(&actual, &path);
        return;
    }
    let golden = read_png(name, &fs::read(&path).unwrap()).unwrap();
    if let Some(complaint) = complaint(name, &golden, &actual) {
        panic!("{complaint}");
    }
}

#[test]
fn chimney_looks_as_it_did() {
    check("chimney", 96);
}

#[test]
fn lamp_looks_as_it_did() {
    check("lamp", 96);
}

#[test]
fn explosion_looks_as_it_did() {
    check("explosion", 14);
}

#[test]
fn cumulus_looks_as_it_did() {
    check("cumulus", 0);
}

#[test]
fn cottage_looks_as_it_did() {
    check("cottage", 150);
}

#[test]
fn engraving_looks_as_it_did() {
    check("engraving", 0);
}

#[test]
fn edges_looks_as_it_did() {
    check("edges", 0);
}

#[test]
fn shadings_looks_as_it_did() {
    check("shadings", 0);
}

#[test]
fn cloud_looks_as_it_did() {
    check("cloud", 0);
}

#[test]
fn genie_looks_as_it_did() {
    check("genie", 96);
}

#[test]
fn rings_look_as_they_did() {
    check("rings", 60);
}

#[test]
fn cloud_simple_looks_as_it_did() {
    check("cloud-simple", 0);
}

#[test]
fn cloud_layers_looks_as_it_did() {
    check("cloud-layers", 0);
}

#[test]
fn cloud_transparent_looks_as_it_did() {
    check("cloud-transparent", 0);
}

#[test]
fn smoke_cel_looks_as_it_did() {
    check("smoke-cel", 96);
}

#[test]
fn metamorphosis_looks_as_it_did() {
    check("metamorphosis", 40);
}

#[test]
fn sketch_looks_as_it_did() {
    check("sketch", 0);
}

#[test]
fn storm_looks_as_it_did() {
    check("storm", 0);
}

#[test]
fn puff_plain_looks_as_it_did() {
    check("puff-plain", 0);
}

#[test]
fn puff_fuzzy_looks_as_it_did() {
    check("puff-fuzzy", 0);
}

#[test]
fn dust_cloud_looks_as_it_did() {
    check("dust-cloud", 20);
}

#[test]
fn haze_looks_as_it_did() {
    check("haze", 0);
}

#[test]
fn smoke_ring_looks_as_it_did() {
    check("smoke-ring", 48);
}

#[test]
fn plasma_looks_as_it_did() {
    check("plasma", 36);
}

#[test]
fn imported_looks_as_it_did() {
    check("imported", 28);
}

#[test]
fn cloud_shadow_looks_as_it_did() {
    check("cloud-shadow", 0);
}

#[test]
fn shell_looks_as_it_did() {
    check("shell", 0);
}

#[test]
fn paint_looks_as_it_did() {
    check("paint", 100);
}

#[test]
fn rain_paints_where_it_lands_as_it_did() {
    check("paint-rain", 100);
}

#[test]
fn powder_tints_what_it_touches_as_it_did() {
    check("paint-powder", 40);
}

#[test]
fn soft_shadows_look_as_they_did() {
    check("soft-shadow", 0);
}

#[test]
fn paint_wash_looks_as_it_did() {
    check("paint-wash", 143);
}

#[test]
fn paint_pour_looks_as_it_did() {
    check("paint-pour", 120);
}

#[test]
fn paint_runs_down_a_hill_as_it_did() {
    check("paint-hill", 100);
}

#[test]
fn day_night_looks_as_it_did() {
    check("day-night", 84);
}

#[test]
fn the_comparison_tells_pictures_apart() {
    let image = |grey: u8, odd: usize| {
        let mut pixels = vec![grey; 4 * 1000];
        pixels[..4 * odd].fill(grey + TOLERANCE + 1);
        Image { width: 100, height: 10, pixels }
    };
    let share = |grey, odd| difference(&image(100, 0), &image(grey, odd)).1;
    assert_eq!(share(100, 0), 0.0);
    assert_eq!(share(100 + TOLERANCE, 0), 0.0);
    assert_eq!(share(101 + TOLERANCE, 0), 1.0);
    assert_eq!(share(100, 6), 0.006);
}
