//! What is exported of a scene is what its pictures show.

use std::collections::BTreeSet;

use fumetto_formats::{Solid, write_glb};
use fumetto_scene::Colour;
use glam::Vec3;

use crate::stage::{Files, Stage, engine, style};

fn solid_of(stage: &Stage, files: Files, frame: u32) -> Solid {
    let engine = engine();
    let mut player = stage.play(&engine, files).unwrap();
    engine.seek(&mut player, frame).unwrap();
    let export = engine.solid(&player, 0).unwrap().unwrap();
    assert_eq!(export.notes, Vec::<String>::new());
    export.solid
}

fn triangles(solid: &Solid) -> impl Iterator<Item = [u32; 3]> {
    solid.groups.iter().flat_map(|group| group.triangles.iter().copied())
}

/// Of a closed surface whose outside is outside.
fn volume(solid: &Solid) -> f32 {
    let place = |corner: u32| Vec3::from(solid.positions[corner as usize]);
    triangles(solid).map(|corners| corners.map(place)).map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
}

/// Every edge has a triangle on either side, which run along it in opposite directions.
fn is_watertight(solid: &Solid) -> bool {
    let sides = || triangles(solid).flat_map(|[a, b, c]| [(a, b), (b, c), (c, a)]);
    let known: BTreeSet<_> = sides().collect();
    known.len() == sides().count() && sides().all(|(a, b)| known.contains(&(b, a)))
}

const TWO: [[f32; 4]; 2] = [[-0.8, 0.0, 0.0, 2.0], [0.9, 0.3, 0.2, 1.6]];

fn surface() -> Stage {
    Stage { style: style(&["#203040", "#c8d4e0"], ""), ..Stage::default() }.surface(
        "cloud",
        &TWO,
        "subdivisions = 24",
        "",
    )
}

#[test]
fn a_surface_is_closed_and_faces_outward() {
    let solid = solid_of(&surface(), Files::default(), 0);
    assert!(is_watertight(&solid));
    assert!(
        triangles(&solid).flatten().collect::<BTreeSet<_>>().len() == solid.positions.len(),
        "none is spare"
    );
    // More than the smaller ball alone within its threshold, less than both balls whole.
    assert!((10.0..51.0).contains(&volume(&solid)), "{}", volume(&solid));
    assert_eq!(solid.groups[0].colour, Colour::from_srgb8([0xc8, 0xd4, 0xe0]), "the lit tone");
    assert!(solid.normals.iter().all(|&normal| (Vec3::from(normal).length() - 1.0).abs() < 1e-5));
}

#[test]
fn a_surface_that_comes_back_as_a_model_looks_the_same() {
    let mut glb = Vec::new();
    write_glb(&[solid_of(&surface(), Files::default(), 0)], &mut glb).unwrap();
    // A model shows its own colours times the tones.
    let model = Stage { style: style(&["#203040", "#c8d4e0"], "material = 0"), ..Stage::default() };
    let model = model.mesh("cloud", "cloud.glb", "");
    let (made, read) = (surface().picture(), model.picture_with(Files::default().with("cloud.glb", glb)));
    let differ = made.places().filter(|&(x, y)| made.rgb(x, y) != read.rgb(x, y)).count();
    assert!(made.drawn() > 10_000 && differ < made.drawn() / 500, "{differ} of {}", made.drawn());
}

#[test]
fn smoke_has_a_surface_at_every_frame() {
    let stage = Stage {
        objects:
            "[[object]]\nname = \"smoke\"\nkind = \"smoke\"\nshape = { surface = { subdivisions = 16 } }\n\
                     [object.emitter]\nshape = { point = { center = [0, 0, 0] } }\nrate = 25\n\
                     velocity = [0, 1, 0]\nradius = 0.5\n"
                .into(),
        ..Stage::default()
    };
    let [early, late] = [12, 48].map(|frame| solid_of(&stage, Files::default(), frame));
    assert!(is_watertight(&early) && is_watertight(&late));
    assert!(volume(&early) > 0.0 && volume(&late) > 1.5 * volume(&early));
    assert_eq!(solid_of(&stage, Files::default(), 12), early, "the same frame is the same");
    assert_eq!(triangles(&solid_of(&stage, Files::default(), 0)).count(), 0, "nothing is born yet");

    let engine = engine();
    let mut player = stage.play(&engine, Files::default()).unwrap();
    engine.seek(&mut player, 12).unwrap();
    let particles = engine.particles(&player, 0).unwrap();
    assert_eq!(particles.len(), 12, "25 a second, half a second long");
    assert!(particles.iter().all(|particle| particle.radius == 0.5 && particle.center[1] >= 0.0));
}

#[test]
fn models_stand_where_their_copies_do() {
    let stage = Stage::default().mesh(
        "boxes",
        "box.glb",
        "transform = [{ position = [5, 0, 0] }, { position = [-5, 0, 0], scale = [-2, 2, 2] }]",
    );
    let solid =
        solid_of(&stage, Files::default().with("box.glb", include_bytes!("../../../../scenes/box.glb")), 0);
    assert_eq!(solid.groups.len(), 2, "one for each material: {:?}", solid.groups);
    let left: Vec<_> = solid.positions.iter().filter(|place| place[0] < 0.0).collect();
    assert_eq!(2 * left.len(), solid.positions.len());
    let height =
        |of: &mut dyn Iterator<Item = &[f32; 3]>| of.fold(0.0, |most: f32, place| most.max(place[1]));
    let [large, small] =
        [height(&mut left.into_iter()), height(&mut solid.positions.iter().filter(|p| p[0] > 0.0))];
    assert!((large / small - 2.0).abs() < 1e-3, "{large} {small}");
    assert!(volume(&solid).is_finite());
}
