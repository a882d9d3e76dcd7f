//! Lines of known shapes, held against what geometry says.

use std::{f32::consts::TAU, fmt::Write as _};

use glam::{Vec2, Vec3};

use super::{CLOUD, EYE, Line, MODEL, Models, SIZE, engine, focal_px, lines, play, scene};

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
