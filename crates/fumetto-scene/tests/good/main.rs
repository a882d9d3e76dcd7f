//! Good scenes mean what they say.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

#[path = "../common/mod.rs"]
mod common;
mod matter;
mod paint;
mod styles;
mod surfaces;
mod volumes;

use common::{load, load_with};
use fumetto_scene::{
    Background, Cluster, Colour, Light, LightKind, Matter, Particle, Puffs, Ramp, Scene, SceneText, Shape,
    Smoke, Tone, Width,
};

fn srgb(hex: u32) -> Colour {
    let [_, red, green, blue] = hex.to_be_bytes();
    Colour::from_srgb8([red, green, blue])
}

fn good(toml: &str) -> Scene {
    let (scene, warnings) = load(toml).unwrap();
    assert!(warnings.is_empty(), "{warnings}");
    scene
}

fn smoke(scene: &Scene) -> &Smoke {
    match &scene.objects[0].matter {
        Matter::Smoke(smoke) => smoke,
        other => panic!("{other:?} is no smoke"),
    }
}

fn set(path: &str, value: &str) -> (String, String) {
    (path.to_owned(), value.to_owned())
}

#[test]
fn the_sketch_of_the_format_is_valid() {
    let scene = good(include_str!("cumulus.toml"));
    assert_eq!(scene.seed, 1);
    assert_eq!(scene.cameras.len(), 1);
    let camera = &scene.cameras[0];
    assert_eq!((camera.name.as_str(), camera.fov_deg, camera.up), ("main", 40.0, [0.0, 1.0, 0.0]));
    let kind = LightKind::Sun { direction: [-0.4, -1.0, -0.3] };
    assert_eq!(scene.lights, [Light { kind, intensity: 1.0, shadow: true, cluster: None }]);
    assert_eq!(scene.background, Background::Transparent);
    assert_eq!((scene.time.fps, scene.time.hold, scene.time.substeps), (24.0, 2, 1));
    assert_eq!((scene.output.size, scene.output.antialias), ([1280, 720], 2));
    let object = &scene.objects[0];
    let particles = [
        Particle { center: [0.0, 1.0, 0.0], radius: 1.0, mass: 8.0 },
        Particle { center: [0.9, 0.9, 0.1], radius: 0.7, mass: 8.0 },
    ];
    assert_eq!(object.matter, Matter::Still(particles.to_vec()));
    let puffs = Puffs { variants: 4, seed: 1, spheres: 24, tile_px: 128, size: 1.0 };
    assert_eq!(object.shape, Shape::Puffs(puffs));
    let tones = vec![Tone { colour: srgb(0x8fa3b8), from: 0.0 }, Tone { colour: srgb(0xe8eef4), from: 0.5 }];
    assert_eq!(object.style.ramp, Ramp::Tones(tones));
    assert_eq!((object.style.ink.colour, object.style.ink.width), (srgb(0x101418), Width::Px(2.0)));
    assert_eq!(object.style.form, 0.7, "what the scene does not say comes from the preset");
}

#[test]
fn every_key_reaches_the_scene() {
    let scene = good(include_str!("everything.toml"));
    assert_eq!(scene.seed, 7);
    assert_eq!(scene.cameras.iter().map(|camera| camera.name.as_str()).collect::<Vec<_>>(), ["front", "top"]);
    assert_eq!((scene.cameras[0].fov_deg, scene.cameras[0].near), (35.0, Some(0.1)));
    let kind = LightKind::Point { position: [0.0, 1.0, 0.0] };
    assert_eq!(scene.lights[1], Light { kind, intensity: 0.5, shadow: false, cluster: None });
    let reach = 3.0_f32.to_radians().tan();
    assert_eq!(scene.lights[0].cluster, Some(Cluster { lights: 5, reach }));
    let bottom = Colour { linear: [0.5, 0.6, 0.7] };
    assert_eq!(scene.background, Background::Gradient { top: srgb(0x406080), bottom });
    assert_eq!((scene.time.frames, scene.time.substeps), ([10, 20], 4));
    let steps = |frame| scene.time.steps_before(frame);
    assert_eq!((steps(0), steps(10)), (24, 64), "half a second of 12 frames, of 4 steps each");
    assert_eq!((scene.output.size, scene.output.antialias), ([640, 360], 1));
    let file = &scene.objects[1];
    assert_eq!(file.matter, Matter::File("cloud.####.ply".into()));
    assert_eq!((file.style.form, file.style.shadow.on), (1.0, false), "an own preset starts afresh");
}

#[test]
fn overrides_reach_every_place() {
    let overrides = [
        set("camera[1].eye[1]", "12"),
        set("camera.front.fov", "50"),
        set("object.fire.style.ink.width.px", "3"),
        set("object[0].emitter[0].rate", "5"),
        set("style.preset", "flat"),
        set("background", "{ colour = \"#102030\" }"),
        set("output.size", "[64, 32]"),
    ];
    let toml = include_str!("everything.toml");
    let text = SceneText { name: "scene.toml", toml, set: &overrides, style: None };
    let (scene, _) = load_with(&text, &[]).unwrap();
    assert_eq!(scene.cameras[1].eye, [0.0, 12.0, 0.0]);
    assert_eq!(scene.cameras[0].fov_deg, 50.0);
    assert_eq!(scene.objects[0].style.ink.width, Width::Px(3.0));
    assert_eq!(smoke(&scene).emitters[0].rate, 5.0);
    assert_eq!(scene.background, Background::Colour(srgb(0x102030)));
    assert_eq!(scene.output.size, [64, 32]);
    assert!(!scene.objects[1].style.shadow.on);
}

#[test]
fn every_8_bit_colour_survives() {
    for level in 0..=255 {
        let srgb = [level, 255 - level, level / 2];
        assert_eq!(Colour::from_srgb8(srgb).to_srgb8(), srgb);
    }
}
