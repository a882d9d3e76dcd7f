//! What a scene says about vortices, and what it does not say.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod common;

use common::{load, load_with};
use fumetto_scene::{Matter, Mouth, Scene, SceneText, Smoke, Vortex, vortex_bytes};

fn good(toml: &str) -> Scene {
    load(toml).unwrap().0
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
fn every_key_of_vortices_reaches_them() {
    let scene = good(include_str!("good/everything.toml"));
    let vortex = Vortex {
        strength: 2.0,
        buoyancy: 0.5,
        core: 0.4,
        viscosity: 0.01,
        decay: 0.1,
        segments: 32,
        error: 0.05,
    };
    assert_eq!(smoke(&scene).vortex, Some(vortex));
    let text = SceneText {
        name: "scene.toml",
        toml: include_str!("good/everything.toml"),
        set: &[set("object.fire.solver", "forces")],
        style: None,
    };
    let (scene, _) = load_with(&text, &[]).unwrap();
    assert_eq!((smoke(&scene).vortex, scene.requirements()[0].vortices), (None, 0));
}

#[test]
fn a_mouth_is_as_wide_as_what_comes_out_of_it() {
    let scene = good(include_str!("good/everything.toml"));
    let mouth = mouth_of(&scene);
    // The disc, and a puff of 0.2 m on average, at 0.3 of that when it is born.
    assert!((mouth.radius - 0.36).abs() < 1e-6, "{}", mouth.radius);
    assert_eq!(mouth.axis, [0.0, 1.0, 0.0]);
    let along = 0.5 * (1.0 + 20.0_f32.to_radians().cos());
    assert!((mouth.speed - along).abs() < 1e-6 && (mouth.speed.hypot(mouth.outward) - 1.0).abs() < 1e-6);
}

#[test]
fn the_cost_of_vortices_is_told_beforehand() {
    let scene = good(include_str!("good/everything.toml"));
    let plans = smoke(&scene).ring_plans(1.0 / 48.0);
    let [jet, on_demand] = [&plans[0], &plans[1]].map(|plan| plan.as_ref().unwrap());
    // 1.3 m/s past 0.72 m, for 2 s and a step, with one for rounding; and one of the bursts at a time.
    let natural = 0.3 * (mouth_of(&scene).speed.powi(2) + 2.0 * 0.72_f32).sqrt() / 0.72;
    let flowing = (f64::from(natural) * (2.0 + 1.0 / 48.0)).ceil() as u64 + 1;
    assert_eq!(jet.capacity, flowing + 1);
    // Half a ring a second for 3 s and a step, and both single ones.
    assert_eq!(on_demand.capacity, 2 + 1 + 2);
    let vortices = 32 * (jet.capacity + on_demand.capacity);
    assert_eq!(scene.requirements()[0].vortices, vortices);
    assert_eq!((vortex_bytes(0), vortex_bytes(100)), (0, 100 * 64 + 2048 * 120));
}

fn mouth_of(scene: &Scene) -> Mouth {
    smoke(scene).emitters[0].mouth()
}

#[test]
fn however_thin_a_jet_is_its_rings_are_few() {
    let set = [
        set("object.fire.emitter[0].shape", "{ point = { center = [0, 0, 0] } }"),
        set("object.fire.emitter[0].radius", "1e-6"),
    ];
    let toml = include_str!("good/everything.toml");
    let (scene, _) = load_with(&SceneText { name: "scene.toml", toml, set: &set, style: None }, &[]).unwrap();
    assert!(scene.requirements()[0].vortices < 10_000, "{}", scene.requirements()[0].vortices);
}

/// The vortices of smoke with `emitters`.
fn vortices(emitters: &str) -> u64 {
    let toml = format!(
        "format = 1\ncamera = {{ eye = [0, 1, 5], target = [0, 1, 0] }}\n\
         [[object]]\nname = \"smoke\"\nkind = \"smoke\"\n{emitters}"
    );
    load(&toml).unwrap().0.requirements()[0].vortices
}

#[test]
fn a_scene_is_not_refused_for_what_it_sheds_of_itself() {
    let emitter = |keys: &str| {
        format!(
            "[[object.emitter]]\nshape = {{ point = {{ center = [0, 0, 0] }} }}\nvelocity = [9, 0, 0]\n{keys}\n"
        )
    };
    let bursts: Vec<_> = (0..300).map(|nth| format!("{{ at = 0.{nth:03}, count = 1 }}")).collect();
    for number in [1, 2, 40, 128, 129, 2000] {
        for keys in
            ["rate = 1", "rate = 1\nlife = 1e-6", &format!("rate = 1\nbursts = [{}]", bursts.join(", "))]
        {
            let asked = vortices(&emitter(keys).repeat(number));
            assert!(asked <= 4 * 128 * 24, "{asked} vortices of {number} emitters");
            assert_eq!(asked == 0, number > 128, "{number} emitters");
        }
    }
}

#[test]
fn what_neither_streams_nor_rises_sheds_nothing() {
    let fog = "[object.emitter]\nshape = { point = { center = [0, 0, 0] } }\nrate = 5\n";
    assert_eq!(vortices(fog), 0);
    let warm = "force = [{ kind = \"buoyancy\", acceleration = 1 }]\n";
    assert!(vortices(&format!("{warm}{fog}")) > 0);
    assert_eq!(vortices(&format!("vortex = {{ buoyancy = 0 }}\n{warm}{fog}")), 0);
    assert_eq!(
        vortices(&format!("vortex = {{ strength = 0, buoyancy = 0 }}\n{fog}velocity = [0, 3, 0]\n")),
        0
    );
}
