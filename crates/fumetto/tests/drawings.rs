//! Vector drawings show what pictures show, without gaps.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::{
    fs, io,
    path::{Path, PathBuf},
    sync::{LazyLock, Mutex, PoisonError},
};

use fumetto::{Assets, DrawingOptions, Engine, Gpu, Layer, Player, Shot};
use fumetto_formats::{Drawing, Folder, Image, Item, Paper, Shape, write_svg};
use fumetto_scene::{Scene, SceneText};
use resvg::{tiny_skia, usvg};

/// Building all pipelines takes longer than most tests do: they share one engine.
static ENGINE: LazyLock<Mutex<Engine>> =
    LazyLock::new(|| Mutex::new(Engine::new(pollster::block_on(Gpu::headless()).unwrap())));

const SIZE: [u32; 2] = [320, 180];

/// Share of places that may be other than the picture's samples say: slits and tips that are narrower than a pixel.
const ODD: f64 = 1e-3;

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

struct Disk;

impl Assets for Disk {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        fs::read(scenes().join(path))
    }
}

/// A puff's cloud, a surface, a volume, and models with smoke.
const SCENES: [(&str, u32); 4] = [("cumulus", 0), ("storm", 0), ("cloud", 0), ("cottage", 40)];

fn play(engine: &Engine, name: &str, frame: u32) -> Player {
    let toml = fs::read_to_string(scenes().join(format!("{name}.toml"))).unwrap();
    let set = [("output.size", "[320, 180]"), ("output.antialias", "4")];
    let set: Vec<_> = set.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    let text = SceneText { name, toml: &toml, set: &set, style: None };
    let scene = Scene::load(&text, &mut |path| {
        fs::read_to_string(scenes().join(path)).map_err(|error| error.to_string())
    });
    let scene = scene.unwrap_or_else(|report| panic!("{}", report.render(false))).0;
    let mut player = engine.play(scene, Box::new(Disk)).unwrap();
    engine.seek(&mut player, frame).unwrap();
    player
}

fn rendered(drawing: &Drawing, scale: u32) -> Image {
    let mut svg = Vec::new();
    write_svg(drawing, &mut svg).unwrap();
    let tree = usvg::Tree::from_data(&svg, &usvg::Options::default()).unwrap();
    let [width, height] = drawing.size_px.map(|side| side * scale);
    let mut pixels = tiny_skia::Pixmap::new(width, height).unwrap();
    let zoom = tiny_skia::Transform::from_scale(scale as f32, scale as f32);
    resvg::render(&tree, zoom, &mut pixels.as_mut());
    Image { width, height, pixels: pixels.take() }
}

fn all_shapes(drawing: &Drawing) -> impl Iterator<Item = &Shape> {
    drawing.layers.iter().flat_map(Folder::shapes)
}

/// Only tones, all opaque, on a plain paper.
fn tones_on(drawing: &Drawing, paper: [u8; 3]) -> Drawing {
    fn strip(folder: &Folder) -> Folder {
        let items = folder.items.iter().filter_map(|item| match item {
            Item::Folder(inner) => (inner.name != "lines").then(|| Item::Folder(strip(inner))),
            Item::Shape(shape) => Some(Item::Shape(Shape { opacity: 1.0, ..shape.clone() })),
        });
        Folder { items: items.collect(), opacity: 1.0, ..folder.clone() }
    }
    let layers = drawing.layers.iter().filter(|layer| layer.name != "lines").map(strip).collect();
    Drawing { layers, paper: Paper::Colour(paper), ..drawing.clone() }
}

#[test]
fn drawings_show_what_pictures_show() {
    let engine = &mut *ENGINE.lock().unwrap_or_else(PoisonError::into_inner);
    for (name, frame) in SCENES {
        let player = play(engine, name, frame);
        let shot = Shot::of(player.scene());
        let picture = engine.picture(&player, &shot).unwrap();
        let drawing = engine.drawing(&player, &shot, &DrawingOptions::default()).unwrap();
        assert!(all_shapes(&drawing).next().is_some(), "{name}");
        let drawn = rendered(&drawing, 1);
        let apart = |(a, b): (&[u8], &[u8])| (0..3).map(|at| a[at].abs_diff(b[at])).max().unwrap();
        let apart: Vec<u8> = picture.pixels.chunks(4).zip(drawn.pixels.chunks(4)).map(apart).collect();
        let mean = apart.iter().map(|&apart| f64::from(apart)).sum::<f64>() / apart.len() as f64;
        let wrong = apart.iter().filter(|&&apart| apart > 64).count() as f64 / apart.len() as f64;
        println!("{name}: mean {mean:.2}, wrong {wrong:.4}, segments {}", drawing.segment_count());
        assert!(mean < 4.0 && wrong < 0.03, "{name}: mean {mean}, wrong {wrong}");
    }
}

#[test]
fn fills_are_closed_and_cover_what_is_drawn_without_gaps() {
    let engine = &mut *ENGINE.lock().unwrap_or_else(PoisonError::into_inner);
    for (name, frame) in SCENES {
        let player = play(engine, name, frame);
        let shot = Shot::of(player.scene());
        let drawing = engine.drawing(&player, &shot, &DrawingOptions::default()).unwrap();
        for shape in all_shapes(&drawing) {
            let elements = shape.path.elements();
            let opened =
                elements.iter().filter(|element| matches!(element, kurbo::PathEl::MoveTo(_))).count();
            let closed =
                elements.iter().filter(|element| matches!(element, kurbo::PathEl::ClosePath)).count();
            assert_eq!(opened, closed, "{name}: {}", shape.name);
        }
        // Where paper shows through, its colour makes a difference.
        let [dark, light] = [[0, 0, 0], [255, 255, 255]].map(|paper| rendered(&tones_on(&drawing, paper), 8));
        let mask = engine.layer(&player, &Shot { antialias: 1, ..shot }, Layer::Alpha).unwrap();
        let [width, height] = SIZE.map(|side| side as usize);
        let is_drawn = |x: usize, y: usize| mask.pixels[4 * (y * width + x)] > 0;
        let mut odd = 0;
        for (y, x) in (1..height - 1).flat_map(|y| (1..width - 1).map(move |x| (y, x))) {
            let around = (0..9).filter(|at| is_drawn(x + at % 3 - 1, y + at / 3 - 1)).count();
            for at in (0..64).map(|at| 4 * ((8 * y + at / 8) * 8 * width + 8 * x + at % 8)) {
                let shows = light.pixels[at].abs_diff(dark.pixels[at]);
                odd += usize::from((around == 9 && shows > 0) || (around == 0 && shows < 255));
            }
        }
        let share = odd as f64 / (64 * width * height) as f64;
        assert!(share < ODD, "{name}: {share}");
    }
}

#[test]
fn ids_stay_from_frame_to_frame() {
    let engine = &mut *ENGINE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut player = play(engine, "cottage", 40);
    let shot = Shot::of(player.scene());
    let mut names = |frame: u32| {
        engine.seek(&mut player, frame).unwrap();
        let drawing = engine.drawing(&player, &shot, &DrawingOptions::default()).unwrap();
        let names: Vec<String> = drawing.layers.iter().map(|layer| layer.name.clone()).collect();
        (names, all_shapes(&drawing).map(|shape| shape.name.clone()).collect::<Vec<_>>())
    };
    assert_eq!(names(40), names(44));
}

#[test]
fn plotters_get_lines_only() {
    let engine = &mut *ENGINE.lock().unwrap_or_else(PoisonError::into_inner);
    let player = play(engine, "cottage", 40);
    let options = DrawingOptions { plotter: true, width_mm: Some(297.0), ..Default::default() };
    let drawing = engine.drawing(&player, &Shot::of(player.scene()), &options).unwrap();
    assert!(all_shapes(&drawing).count() > 2);
    assert!(all_shapes(&drawing).all(|shape| shape.stroke_px.is_some_and(|width| width > 0.0)));
    assert_eq!(drawing.paper, Paper::Clear);
}
