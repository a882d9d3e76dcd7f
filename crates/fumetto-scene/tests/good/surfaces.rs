//! Surfaces around particles, and what they cost.

use super::{common::load_with, good, set};
use fumetto_scene::{
    Detail, Ink, InkMethod, Matter, Noise, Particle, Resolution, SceneText, Spacing, Surface, Width,
};

/// The surface `shape` of two balls of radius 1 whose middles are 3 m apart.
fn two_balls(shape: &str) -> (Surface, Vec<Particle>) {
    let scene = good(&format!(
        "format = 1\ncamera = {{ eye = [0, 1, 5], target = [0, 0, 0] }}\n\
         light = [{{ kind = \"sun\", direction = [0, -1, 0] }}]\n\
         object = [{{ name = \"a\", kind = \"cloud\", shape = {{ surface = {{ {shape} }} }}, particles = [\n\
         {{ center = [0, 5, 0], radius = 1 }}, {{ center = [3, 5, 0], radius = 1 }} ] }}]"
    ));
    let Matter::Still(particles) = &scene.objects[0].matter else { panic!("a still cloud") };
    (*scene.objects[0].shape.surface().unwrap(), particles.clone())
}

#[test]
fn a_changing_surfaces_cells_suit_all_its_sets() {
    let (surface, two) = two_balls("subdivisions = 25");
    let far = [Particle { center: [20.0, 0.0, 0.0], radius: 2.0, mass: 1.0 }];
    let plan = surface.plan_morph(&[&two, &far, &[]]);
    // The wider set is 5 m long, and between both lie 23 m.
    assert_eq!(plan.spacing, Spacing::Cell(0.2));
    assert!(plan.room.blocks > surface.plan(&two).room.blocks && plan.room.particles == 3);
    assert_eq!(surface.plan_morph(&[&[], &[]]).room.particles, 1, "nothing is no reason to fail");
}

#[test]
fn every_key_of_a_surface_reaches_it() {
    let resolution = Resolution::Subdivisions(48);
    let plain = Surface { threshold: 0.05, resolution, size: 1.0, noise: None };
    assert_eq!(two_balls("").0, plain);
    let noise = Noise { amplitude: 2.0, size_m: 0.5, octaves: 3, seed: 1, drift_m_per_s: [0.0, 1.5, 0.0] };
    let noisy = Surface { threshold: 0.6, size: 1.5, noise: Some(noise), ..plain };
    assert_eq!(
        two_balls("threshold = 0.6, size = 1.5, noise = { amplitude = 2, size = 0.5, drift = [0, 1.5, 0] }")
            .0,
        noisy
    );
    for (keys, resolution) in [
        ("subdivisions = 22", Resolution::Subdivisions(22)),
        ("cell = 0.1", Resolution::Cell(0.1)),
        ("per_radius = 4", Resolution::PerRadius(4.0)),
        ("pixels = 6", Resolution::Picture(6.0 / 720.0)),
    ] {
        assert_eq!(two_balls(keys).0, Surface { resolution, ..plain });
    }
}

#[test]
fn a_layer_of_detail_takes_what_it_does_not_say_from_the_surface_around_it() {
    let details = |keys: &str| {
        let scene = good(&format!(
            "format = 1\ncamera = {{ eye = [0, 1, 5], target = [0, 0, 0] }}\n\
             light = [{{ kind = \"sun\", direction = [0, -1, 0] }}]\n\
             object = [{{ name = \"a\", kind = \"cloud\", particles = [{{ center = [0, 5, 0], radius = 1 }}], \
             style = {{ ink = {{ width = {{ px = 5 }}, inner = 0.25 }} }}, shape = {{ surface = {{ \
             threshold = 0.3, size = 2, subdivisions = 20, noise = {{ amplitude = 1, size = 1 }}, {keys} }} }} }}]"
        ));
        let object = &scene.objects[0];
        (object.shape.surface().copied().unwrap(), object.style.ink.clone(), object.details.clone())
    };
    assert_eq!(details("").2, []);
    let (outer, ink, plain) = details("detail = [{}]");
    assert_eq!(plain, [Detail { surface: Surface { size: 1.6, ..outer }, mass: 1.0, ink: ink.clone() }]);
    let (_, _, two) = details(
        "detail = [{ size = 0.5, mass = 0.25, ink = { width = { px = 2 }, method = \"vector\" } }, \
         { threshold = 0.6, cell = 0.1, noise = { amplitude = 0, size = 1 } }]",
    );
    let surface = Surface { size: 1.0, ..outer };
    let pen = Ink { width: Width::Px(2.0), method: InkMethod::Vector, ..ink };
    assert_eq!(two[0], Detail { surface, mass: 0.25, ink: pen });
    let inner = two[1].surface;
    assert_eq!((inner.threshold, inner.resolution, inner.size), (0.6, Resolution::Cell(0.1), 1.6));
    assert_eq!(inner.noise.map(|noise| noise.amplitude), Some(0.0));
}

#[test]
fn a_surfaces_cells_are_as_large_as_asked_for() {
    // From -1 to 4 along x.
    for (keys, cell_m) in [
        ("subdivisions = 25", 0.2),
        ("subdivisions = 20, size = 0.5", 0.2),
        ("cell = 0.1", 0.1),
        ("per_radius = 4", 0.25),
    ] {
        let (surface, particles) = two_balls(keys);
        assert_eq!(surface.plan(&particles).spacing, Spacing::Cell(cell_m), "{keys}");
    }
    let (surface, particles) = two_balls("subdivisions = 25");
    assert_eq!(surface.plan_sequence(&particles).spacing, Spacing::Subdivisions(25.0));
    assert_eq!(surface.plan(&[]).room.particles, 1, "nothing is no reason to fail");
}

#[test]
fn cells_in_pixels_have_room_for_a_cloud_that_fills_the_picture() {
    let plans = |keys: &str| {
        let (surface, two) = two_balls(keys);
        let far = [Particle { center: [20.0, 0.0, 0.0], radius: 2.0, mass: 1.0 }];
        [surface.plan(&two), surface.plan_sequence(&two), surface.plan_morph(&[&two, &far])]
    };
    // 120 of them lie along the picture's height.
    let (share, most) = (6.0 / 720.0, 240.0);
    assert_eq!(plans("pixels = 6").map(|plan| plan.spacing), [Spacing::Picture { share, most }; 3]);
    let [still, sequence, _] = plans("subdivisions = 240");
    let [near, moving, _] = plans("pixels = 6").map(|plan| plan.room);
    assert_eq!(moving, sequence.room);
    // Other cells touch other blocks: it is not known in advance which.
    assert_eq!(near.or(still.room), near, "there is room for what cells that stay as they are need");
    // There is an end to both sides: 128 MiB for the triangles, and a cloud of which hardly any cell is left.
    for (keys, along) in [("pixels = 1", 256.0), ("pixels = 512", 8.0)] {
        for plan in plans(keys) {
            assert!(matches!(plan.spacing, Spacing::Picture { most, .. } if most == along), "{plan:?}");
            assert!(plan.room.parts().iter().all(|(_, count, bytes)| count * bytes <= 64 << 20), "{plan:?}");
        }
    }
}

#[test]
fn a_surfaces_room_grows_with_its_area_and_its_particles() {
    let room = |cells: u32| {
        let (surface, particles) = two_balls(&format!("subdivisions = {cells}"));
        surface.plan(&particles).room
    };
    let [coarse, fine] = [room(128), room(256)];
    let growth = f64::from(fine.triangles) / f64::from(coarse.triangles);
    assert!((3.0..4.2).contains(&growth), "{growth} times the triangles for cells of half the size");
    let growth = f64::from(fine.entries) / f64::from(coarse.entries);
    assert!((5.0..8.2).contains(&growth), "{growth} times the room on lists");
    assert!(fine.bytes() < 256 << 20, "{} bytes", fine.bytes());
}

#[test]
fn the_cost_of_a_surface_is_told_beforehand() {
    let set = [set("object.fire.shape", "{ surface = { subdivisions = 32 } }")];
    let toml = include_str!("everything.toml");
    let text = SceneText { name: "scene.toml", toml, set: &set, style: None };
    let (scene, _) = load_with(&text, &[]).unwrap();
    let cost = &scene.requirements()[0];
    assert_eq!(cost.surface.map(|room| u64::from(room.particles)), cost.particles);
    assert_eq!(scene.requirements()[1].surface, None);
}
