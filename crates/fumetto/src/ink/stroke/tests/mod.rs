//! Lines as they are put in order on the device, read back.

mod shapes;

use std::{fmt::Write as _, io};

use fumetto_scene::{Scene, SceneText};
use glam::{Vec2, Vec3};
use pollster::block_on;

use crate::{
    Assets, Engine, Error, Gpu, Layer, Player, Shot,
    gpu::{read_buffer, read_items},
};

/// `Joint` of `joint.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
struct Joint {
    px: [f32; 2],
    depth: f32,
    along: f32,
    outward: u32,
    pen: u32,
    candidate: u32,
    first: u32,
    last: u32,
    is_closed: u32,
    lit: f32,
    pad: u32,
}

/// `Shape` of `shape.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
struct Shape {
    px: [f32; 2],
    tangent: [f32; 2],
    bend: f32,
    before: f32,
    after: f32,
    shows: u32,
}

/// A line in order.
#[derive(Clone, Debug, PartialEq)]
struct Line {
    joints: Vec<Joint>,
    shapes: Vec<Shape>,
}

impl Line {
    fn is_closed(&self) -> bool {
        self.joints[0].is_closed != 0
    }

    fn places(&self) -> impl Iterator<Item = Vec2> {
        self.joints.iter().map(|joint| joint.px.into())
    }

    /// Of all of it, then of what is drawn.
    fn lengths_px(&self) -> [f32; 2] {
        let pieces = self.joints.windows(2).zip(&self.shapes);
        pieces.fold([0.0; 2], |[all, drawn], (ends, shape)| {
            let length = Vec2::from(ends[0].px).distance(ends[1].px.into());
            [all + length, drawn + length * shape.shows as f32]
        })
    }
}

/// Models in memory, by name.
#[derive(Clone)]
struct Models(Vec<(&'static str, Vec<u8>)>);

impl Assets for Models {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        let model = self.0.iter().find(|(name, _)| *name == path);
        model.map(|(_, bytes)| bytes.clone()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

fn engine() -> Engine {
    Engine::new(block_on(Gpu::headless()).expect("a Vulkan driver"))
}

const EYE: Vec3 = Vec3::new(0.0, 0.0, 6.0);
const SIZE: [f32; 2] = [240.0, 180.0];
const FOV_DEG: f32 = 30.0;

fn focal_px() -> f32 {
    0.5 * SIZE[1] / (0.5 * FOV_DEG).to_radians().tan()
}

/// A scene with the camera at `EYE`, looking at the origin.
fn scene(objects: &str, stroke: &str) -> Scene {
    let toml = format!(
        "format = 1\ncamera = {{ eye = [0, 0, 6], target = [0, 0, 0], fov = 30 }}\n\
         output = {{ size = [240, 180], antialias = 1 }}\n\
         [style]\nink = {{ width = {{ px = 4 }}, shortest = 0, stroke = {{ {stroke} }} }}\nheight = 180\n{objects}\n"
    );
    let text = SceneText { name: "test", toml: &toml, ..Default::default() };
    let loaded = Scene::load(&text, &mut |_| Err("there are no styles".into()));
    loaded.unwrap_or_else(|report| panic!("{}", report.render(false))).0
}

fn play(engine: &mut Engine, scene: Scene, models: &Models) -> Player {
    let mut player = engine.play(scene, Box::new(models.clone())).expect("the scene can be played");
    engine.seek(&mut player, 0).expect("there is a frame 0");
    player
}

/// The lines of the list that is drawn last.
fn lines(engine: &mut Engine, player: &Player) -> Vec<Line> {
    engine.layer(player, &Shot::of(player.scene()), Layer::Ink).expect("the device works");
    let room = &engine.painter.strokes.as_ref().expect("the scene has strokes").room;
    let tally: Vec<u32> = read_buffer(engine.gpu(), &room.joint_tally).expect("the device works");
    let joints: Vec<Joint> =
        block_on(read_items(engine.gpu(), &room.joints, 0..tally[3])).expect("the device works");
    let shapes: Vec<Shape> =
        block_on(read_items(engine.gpu(), &room.shapes, 0..tally[3])).expect("the device works");
    let same = joints.chunk_by(|a, b| a.first == b.first);
    let line = |joints: &[Joint]| {
        let [first, last] = [joints[0].first as usize, joints[0].last as usize];
        assert_eq!(last - first + 1, joints.len(), "joints know their line");
        Line { joints: joints.to_vec(), shapes: shapes[first..=last].to_vec() }
    };
    same.map(line).collect()
}

const CLOUD: &str = "[[object]]\nname = \"ball\"\nkind = \"cloud\"\n\
                     particles = [{ center = [0, 0, 0], radius = 1.2, mass = 1 }]\n";

const MODEL: &str = "[[object]]\nname = \"model\"\nkind = \"mesh\"\nmodel = \"model.obj\"\nsmooth = 180\n";

#[test]
fn more_lines_than_there_is_room_for_are_left_out() {
    let mut engine = engine();
    let mut model = String::new();
    for number in 0..60_000 {
        let (x, y) = (f64::from(number % 300) / 120.0 - 1.25, f64::from(number / 300) / 90.0 - 1.1);
        let _ = writeln!(model, "v {x} {y} 0\nv {} {y} 0\nv {x} {} 0", x + 0.004, y + 0.004);
        let first = 3 * number + 1;
        let _ = writeln!(model, "f {first} {} {}", first + 1, first + 2);
    }
    let player =
        play(&mut engine, scene(MODEL, "texture = \"chalk\""), &Models(vec![("model.obj", model.into())]));
    let lines = lines(&mut engine, &player);
    let pieces = engine.painter.strokes.as_ref().expect("the scene has strokes").room.pieces as usize;
    let joints: usize = lines.iter().map(|line| line.joints.len()).sum();
    assert!(pieces == 1 << 17 && joints <= 2 * pieces, "{joints} joints of {pieces} pieces");
    assert!(lines.len() > pieces / 2, "{} lines", lines.len());
}

#[test]
fn pieces_without_length_are_no_trouble() {
    let mut engine = engine();
    let model = "v 0 0 0\nv 0 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 4 5\nf 4 4 5\n";
    let player =
        play(&mut engine, scene(MODEL, "texture = \"pencil\""), &Models(vec![("model.obj", model.into())]));
    for line in lines(&mut engine, &player) {
        assert!(line.joints.iter().all(|joint| joint.px.iter().all(|px| px.is_finite())), "{line:?}");
        assert!(line.shapes.iter().all(|shape| shape.px.iter().all(|px| px.is_finite())), "{line:?}");
    }
}

#[test]
fn a_frame_is_the_same_however_it_is_reached_and_the_hand_draws_anew_when_told() {
    let mut engine = engine();
    let object = format!("{CLOUD}shape = {{ surface = {{ threshold = 0.36, subdivisions = 24 }} }}");
    let mut ink = |stroke: &str, frames: &[u32]| {
        let mut player = play(&mut engine, scene(&object, stroke), &Models(Vec::new()));
        for &frame in frames {
            engine.seek(&mut player, frame).expect("the frame can be drawn");
        }
        engine.picture(&player, &Shot::of(player.scene())).expect("the device works").pixels
    };
    let boiling = "texture = \"pencil\", boil = 4";
    assert_eq!(ink(boiling, &[9]), ink(boiling, &[30, 3, 9]));
    assert_eq!(ink(boiling, &[8]), ink(boiling, &[11]), "the same drawing");
    assert_ne!(ink(boiling, &[8]), ink(boiling, &[12]), "drawn anew");
    let steady = "texture = \"pencil\"";
    assert_eq!(ink(steady, &[0]), ink(steady, &[100]));
}

#[test]
fn a_texture_that_is_no_picture_is_refused_by_name() {
    let object = format!("{CLOUD}shape = {{ surface = {{ threshold = 0.36, subdivisions = 12 }} }}");
    let scene = scene(&object, "texture = \"stroke.png\"");
    let models = Models(vec![("stroke.png", b"not a picture".to_vec())]);
    let refused = engine().play(scene, Box::new(models)).err();
    assert!(matches!(&refused, Some(Error::Format(_))), "{refused:?}");
    assert!(refused.is_some_and(|error| error.to_string().contains("stroke.png")));
}
