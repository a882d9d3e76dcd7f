//! Lines as they are put in order on the device, read back and held against what geometry says.

use std::{f32::consts::TAU, fmt::Write as _, io};

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

/// The picture of a ball's contour, a circle around the picture's middle.
fn circle_px(radius: f32) -> f32 {
    focal_px() * radius / (EYE.z * EYE.z - radius * radius).sqrt()
}

#[test]
fn a_balls_silhouette_is_one_closed_line_on_the_analytic_circle() {
    let mut engine = engine();
    // Where equation 2 of Álvarez is the threshold.
    let radius = 1.2 * (1.0 - 0.36_f32.sqrt()).sqrt();
    let expected = circle_px(radius);
    for subdivisions in [12, 24, 48] {
        let object =
            format!("{CLOUD}shape = {{ surface = {{ threshold = 0.36, subdivisions = {subdivisions} }} }}");
        let player = play(&mut engine, scene(&object, "texture = \"brush\""), &Models(Vec::new()));
        let lines = lines(&mut engine, &player);
        assert_eq!(lines.len(), 1, "lines at {subdivisions}");
        let line = &lines[0];
        assert!(line.is_closed());
        assert_eq!(line.joints[0].px, line.joints[line.joints.len() - 1].px, "it ends where it begins");
        let off = line.places().map(|place| (place.distance(Vec2::from(SIZE) / 2.0) - expected).abs());
        let off = off.fold(0.0, f32::max);
        assert!(off < 0.03 * expected, "{off} px off a circle of {expected} at {subdivisions}");
        // Stable when the mesh gets finer.
        let [length, drawn] = line.lengths_px();
        assert!((length / (TAU * expected) - 1.0).abs() < 0.03, "{length} px at {subdivisions}");
        assert!(drawn > 0.999 * length, "{drawn} of {length} px are seen at {subdivisions}");
        // It begins at its feet: downward on the picture.
        let feet = line.places().next().expect("lines have joints");
        assert!(feet.y > SIZE[1] / 2.0 + 0.8 * expected, "it begins at {feet}");
        assert!(line.joints.windows(2).all(|two| two[0].along <= two[1].along));
    }
}

/// A surface as OBJ: `place` of two shares from 0 to 1, of which the first comes round, and the second if it `wraps`.
fn grid([steps, rows]: [usize; 2], wraps: bool, place: impl Fn(f32, f32) -> Vec3) -> Vec<u8> {
    let places = if wraps { rows } else { rows + 1 };
    let mut obj = String::new();
    for u in 0..steps {
        for v in 0..places {
            let Vec3 { x, y, z } = place(u as f32 / steps as f32, v as f32 / rows as f32);
            // Writing to a string cannot fail.
            let _ = writeln!(obj, "v {x} {y} {z}");
        }
    }
    let corner = |u: usize, v: usize| 1 + (u % steps) * places + v % places;
    for u in 0..steps {
        for v in 0..rows {
            let [a, b, c, d] = [corner(u, v), corner(u + 1, v), corner(u + 1, v + 1), corner(u, v + 1)];
            let _ = writeln!(obj, "f {a} {b} {c}\nf {a} {c} {d}");
        }
    }
    obj.into_bytes()
}

const RING: f32 = 1.0;
const TUBE: f32 = 0.35;

/// Of a torus that is tilted toward the viewer.
fn torus(u: f32, v: f32) -> [Vec3; 2] {
    let tilt = |p: Vec3| glam::Quat::from_rotation_x(0.5) * p;
    let (around, out) = (TAU * u, TAU * v);
    let outward = Vec3::new(around.cos(), 0.0, around.sin());
    let normal = outward * out.cos() + Vec3::Y * out.sin();
    [tilt(outward * RING + normal * TUBE), tilt(normal)]
}

fn px_of(place: Vec3) -> Vec2 {
    let seen = place - EYE;
    Vec2::from(SIZE) / 2.0 + Vec2::new(seen.x, -seen.y) * (focal_px() / -seen.z)
}

/// Places where a torus turns away from the viewer: of each of its circles two.
fn torus_contour() -> Vec<Vec2> {
    let mut places = Vec::new();
    for step in 0..2000 {
        let u = step as f32 / 2000.0;
        let turned = |v: f32| {
            let [place, normal] = torus(u, v);
            normal.dot(EYE - place)
        };
        for at in 0..400 {
            let [a, b] = [at as f32 / 400.0, (at + 1) as f32 / 400.0];
            if (turned(a) < 0.0) != (turned(b) < 0.0) {
                let v = a + (b - a) * turned(a) / (turned(a) - turned(b));
                places.push(px_of(torus(u, v)[0]));
            }
        }
    }
    places
}

const MODEL: &str = "[[object]]\nname = \"model\"\nkind = \"mesh\"\nmodel = \"model.obj\"\nsmooth = 180\n";

#[test]
fn a_torus_has_its_two_known_contours_one_of_which_is_partly_hidden() {
    let mut engine = engine();
    let expected = torus_contour();
    for steps in [[96, 48], [160, 80]] {
        let model = grid(steps, true, |u, v| torus(u, -v)[0]);
        let player =
            play(&mut engine, scene(MODEL, "texture = \"brush\""), &Models(vec![("model.obj", model)]));
        let mut lines = lines(&mut engine, &player);
        assert_eq!(lines.len(), 2, "lines");
        assert!(lines.iter().all(Line::is_closed));
        for place in lines.iter().flat_map(Line::places) {
            let off = expected.iter().map(|known| known.distance(place)).fold(f32::MAX, f32::min);
            assert!(off < 1.0, "{place} lies {off} px off the contour");
        }
        lines.sort_by(|a, b| b.lengths_px()[0].total_cmp(&a.lengths_px()[0]));
        let shares = lines.iter().map(|line| line.lengths_px()[1] / line.lengths_px()[0]);
        let shares: Vec<f32> = shares.collect();
        assert!(shares[0] > 0.98, "the outer one is seen all round: {shares:?}");
        assert!((0.3..0.95).contains(&shares[1]), "the inner one hides between its cusps: {shares:?}");
        // What is seen of it is not in crumbs: it has as many runs as the hole has sides.
        let inner = &lines[1].shapes[..lines[1].shapes.len() - 1];
        let begins = inner.iter().zip(inner.iter().cycle().skip(inner.len() - 1));
        let runs = begins.filter(|(own, before)| own.shows == 1 && before.shows == 0).count();
        assert!((1..=2).contains(&runs), "{runs} runs");
    }
}

#[test]
fn of_crossing_balls_the_right_arcs_are_seen() {
    let mut engine = engine();
    let ball = |u: f32, v: f32| {
        let (around, down) = (TAU * u, 0.5 * TAU * v);
        // A pole is one place.
        let out = if v == 0.0 || v == 1.0 { 0.0 } else { down.sin() };
        Vec3::new(out * around.cos(), down.cos(), -out * around.sin())
    };
    let models = Models(vec![("model.obj", grid([64, 32], false, ball))]);
    let copies =
        "transform = [{ position = [-0.36, 0, 0], scale = 0.6 }, { position = [0.36, 0, 0], scale = 0.6 }]";
    let player =
        play(&mut engine, scene(&format!("{MODEL}{copies}"), "texture = \"brush\", taper = 0"), &models);
    let lines = lines(&mut engine, &player);
    assert_eq!(lines.len(), 2, "each has its contour");
    // Each circle of 1, its middle 0.6 from the plane between both, is cut off at an angle with that cosine.
    let expected = 1.0 - 0.6_f32.acos() / (0.5 * TAU);
    for line in &lines {
        let [length, drawn] = line.lengths_px();
        assert!((drawn / length - expected).abs() < 0.04, "{} instead of {expected}", drawn / length);
    }
}

#[test]
fn lines_along_edges_end_at_corners_and_inside_nothing_is_drawn() {
    let mut engine = engine();
    let cube = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n\
                f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";
    let models = Models(vec![("model.obj", cube.into())]);
    let turned = "transform = { scale = 0.5, rotation = [25, 35, 0] }";
    let object = format!("{}{turned}", MODEL.replace("180", "0"));
    let player = play(&mut engine, scene(&object, "texture = \"brush\""), &models);
    let lines = lines(&mut engine, &player);
    assert!(lines.iter().all(|line| !line.is_closed()));
    assert_eq!(lines.len(), 12, "each edge is a stroke of its own");
    let seen = lines.iter().filter(|line| line.lengths_px()[1] > 0.9 * line.lengths_px()[0]).count();
    assert_eq!(seen, 9, "three meet at the corner that is farthest");

    // Long lines have joints for all of their length, though there are few pieces.
    let long = object.replace("scale = 0.5", "scale = 1.2");
    let player = play(&mut engine, scene(&long, "texture = \"brush\""), &models);
    let lines = self::lines(&mut engine, &player);
    assert_eq!(lines.len(), 12, "no line is lost");
    let joints: usize = lines.iter().map(|line| line.joints.len()).sum();
    assert!(joints > 200, "{joints} joints");

    // All of a ball around the viewer faces them, or none.
    let around = format!(
        "{}shape = {{ surface = {{ threshold = 0.36, subdivisions = 24 }} }}",
        CLOUD.replace("1.2", "40")
    );
    let player = play(&mut engine, scene(&around, "texture = \"brush\""), &Models(Vec::new()));
    assert_eq!(self::lines(&mut engine, &player), Vec::new());
}

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
