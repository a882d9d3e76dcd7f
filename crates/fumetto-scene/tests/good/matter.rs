//! What objects are made of: smoke, models, particles that become others.

use super::{good, smoke};
use fumetto_scene::{
    Burst, Curve, Ease, EmitterShape, Force, Given, Matter, Mesh, Metamorphosis, Morph, Particle, Rings,
    Smoke, Transform,
};

#[test]
fn every_key_of_smoke_reaches_it() {
    let scene = good(include_str!("everything.toml"));
    let Smoke { emitters, forces, .. } = smoke(&scene);
    let emitter = &emitters[0];
    let disc = EmitterShape::Disc { center: [0.0; 3], normal: [0.0, 1.0, 0.0], radius: 0.3, hole: 0.25 };
    assert_eq!(emitter.shape, disc);
    assert_eq!((emitter.rate, emitter.count, emitter.active), (60.0, None, [0.0, 2.0]));
    assert_eq!(emitter.bursts, [Burst { at: 0.5, count: 100 }, Burst { at: 9.0, count: 50 }]);
    assert_eq!((emitter.spread_deg, emitter.speed_jitter), (20.0, 0.2));
    assert_eq!([emitter.life, emitter.radius, emitter.mass], [[2.0, 4.0], [0.1, 0.3], [2.0, 2.0]]);
    assert_eq!(emitter.radius_over_life, Curve { points: vec![[0.0, 0.3], [1.0, 2.0]] });
    assert_eq!(emitter.mass_over_life, Curve::constant(1.0));
    assert_eq!(emitter.erosion_over_life, Curve::constant(0.25));
    assert_eq!(emitters[1].count, Some(500));
    assert_eq!(emitters[0].rings, None);
    let rings = Rings { circulation: -2.0, rate: 0.5, at: vec![1.0, 2.5], radius: Some(0.4), wobble: 0.2 };
    assert_eq!(emitters[1].rings, Some(rings));
    assert_eq!(forces.len(), 7);
    assert_eq!(forces[0], Force::Gravity { acceleration: [0.0, -9.81, 0.0] });
    assert_eq!(forces[3], Force::Wind { velocity: [1.0, 0.0, 0.0], gust: 0.3, gust_secs: 3.0 });
    assert_eq!(forces[4], Force::Turbulence { speed: 0.5, scale: 1.0, octaves: 3, drift: [0.0; 3] });
}

#[test]
fn costs_are_told_beforehand() {
    let scene = good(include_str!("everything.toml"));
    let costs = scene.requirements();
    // 60 a second for 2 s and a step, one for rounding, the larger burst, and 500 kept alive.
    let particles = (60.0_f64 * (2.0 + 1.0 / 48.0)).ceil() as u64 + 1 + 100 + 500;
    assert_eq!((costs[0].particles, costs[0].state_bytes), (Some(particles), Some(particles * 96)));
    assert_eq!(costs[1].particles, None, "only the file knows");
}

#[test]
fn a_curve_is_linear_between_its_points_and_stays_outside() {
    let curve = Curve { points: vec![[0.2, 1.0], [0.6, 3.0]] };
    let at = [0.0, 0.2, 0.4, 0.6, 1.0].map(|age| curve.at(age));
    let expected = [1.0, 1.0, 2.0, 3.0, 3.0];
    assert!(at.iter().zip(expected).all(|(got, wanted)| (got - wanted).abs() < 1e-6), "{at:?}");
}

#[test]
fn a_mesh_stands_where_its_transforms_say() {
    let scene = good(
        r#"
        format = 1
        camera = { eye = [0, 1, 5], target = [0, 0, 0] }
        light = [{ kind = "sun", direction = [0, -1, 0] }]
        object = [
            { name = "house", kind = "mesh", model = "house.glb", style = { material = 0.5 } },
            { name = "trees", kind = "mesh", model = "tree.obj", up = "z", smooth = 30, obstacle = true, transform = [
                { position = [1, 2, 3], rotation = [0, 90, 0], scale = 2 },
                { scale = [1, -2, 1] },
            ] },
        ]
        "#,
    );
    let mesh = |index: usize| match &scene.objects[index].matter {
        Matter::Mesh(mesh) => mesh.clone(),
        other => panic!("{other:?} is no mesh"),
    };
    let house = Mesh {
        model: "house.glb".into(),
        z_up: false,
        smooth_deg: None,
        copies: vec![Transform::default()],
        obstacle: false,
    };
    assert_eq!(mesh(0), house);
    assert_eq!(scene.objects[0].style.material, 0.5);
    let trees = Mesh {
        model: "tree.obj".into(),
        z_up: true,
        smooth_deg: Some(30.0),
        copies: vec![
            Transform { position: [1.0, 2.0, 3.0], rotation_deg: [0.0, 90.0, 0.0], scale: [2.0; 3] },
            Transform { scale: [1.0, -2.0, 1.0], ..Transform::default() },
        ],
        obstacle: true,
    };
    assert_eq!(mesh(1), trees);
}

#[test]
fn a_cloud_may_become_others() {
    let scene = good(
        r#"
        format = 1
        camera = { eye = [0, 1, 5], target = [0, 0, 0] }
        light = [{ kind = "sun", direction = [0, -1, 0] }]
        [[object]]
        name = "cloud"
        kind = "cloud"
        particles = [{ center = [0, 5, 0], radius = 1 }]
        [[object.morph]]
        during = [1, 3]
        particles = "rabbit.csv"
        [[object.morph]]
        during = [3, 4.5]
        particles = [{ center = [1, 2, 3], radius = 0.5, mass = 2 }]
        ease = "linear"
        "#,
    );
    let one = |center, radius, mass| Given::Listed(vec![Particle { center, radius, mass }]);
    let morph = |during_secs, particles, ease| Morph { during_secs, particles, ease };
    let expected = Metamorphosis {
        start: one([0.0, 5.0, 0.0], 1.0, 1.0),
        changes: vec![
            morph([1.0, 3.0], Given::File("rabbit.csv".into()), Ease::InOut),
            morph([3.0, 4.5], one([1.0, 2.0, 3.0], 0.5, 2.0), Ease::Linear),
        ],
    };
    assert_eq!(scene.objects[0].matter, Matter::Morph(expected));
    assert_eq!(scene.objects[0].capacity(0.1), None, "a file tells");
}

#[test]
fn a_curves_mean_counts_what_lies_outside_its_points() {
    let curve = Curve { points: vec![[0.2, 1.0], [0.6, 3.0]] };
    assert!((curve.mean() - (0.2 + 0.4 * 2.0 + 0.4 * 3.0)).abs() < 1e-6, "{}", curve.mean());
    assert_eq!((curve.largest(), Curve::constant(2.0).mean()), (3.0, 2.0));
}
