//! Good scenes mean what they say.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod common;

use common::{load, load_with};
use fumetto_scene::{
    Along, Background, Border, Brush, Burst, Cells, Cluster, Colour, Curve, Detail, Drop, Ease, EdgeKind,
    Emitter, EmitterShape, Exaggerate, Follow, Force, Given, Gooch, Growth, Hatching, Highlight, Imported,
    Ink, InkMethod, Light, LightKind, Look, Matter, Mesh, Metamorphosis, Morph, Noise, Paint, Particle, Pour,
    Profile, Puffs, Ramp, RampImage, RampRows, Raw, RawNumber, Resolution, Rim, Rings, Scene, SceneText,
    Shading, Shape, Smoke, Spacing, Spread, Stain, StainRoom, Stroke, StrokeTexture, Style, StyleChoice,
    Surface, Tone, Transform, Volume, VolumeNoise, Wash, Width,
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
    let scene = good(include_str!("good/cumulus.toml"));
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
    let scene = good(include_str!("good/everything.toml"));
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
    assert_eq!((scene.output.size, scene.output.antialias), ([640, 360], 1));
    let file = &scene.objects[1];
    assert_eq!(file.matter, Matter::File("cloud.####.ply".into()));
    assert_eq!((file.style.form, file.style.shadow.on), (1.0, false), "an own preset starts afresh");
}

#[test]
fn every_key_of_paint_reaches_it() {
    let scene = good(include_str!("good/everything.toml"));
    let Matter::Paint(paint) = &scene.objects[2].matter else { panic!("paint") };
    let growth = |points: &[[f32; 2]]| Growth { points: points.to_vec() };
    let Look::Styled(outside) = paint.outside.as_ref().unwrap() else { panic!("a style") };
    assert_eq!(outside.len(), 3, "one for each object");
    for (style, object) in outside.iter().zip(&scene.objects) {
        let tones = [Tone { colour: srgb(0x1b2148), from: 0.0 }, Tone { colour: srgb(0x5d6cb0), from: 0.5 }];
        let ramp = Ramp::Tones(tones.to_vec());
        assert_eq!(*style, Style { ramp, ..object.style.clone() }, "the rest is the object's own");
    }
    let room = |emitter: &Emitter| StainRoom::new(emitter.capacity(scene.time.step_secs()), 2, 50);
    let rooms: Vec<_> = smoke(&scene).emitters.iter().map(room).collect();
    assert_eq!(rooms[1], StainRoom { particles: 250, rounds: 1 }, "half of the 500 that are alive");
    let expected = Paint {
        drops: vec![
            Drop {
                at: [0.0, 1.0, 0.0],
                time_secs: 0.5,
                radius: growth(&[[0.0, 0.2], [3.0, 2.0]]),
                start_m: 0.1,
            },
            Drop { at: [1.0, 0.0, 0.0], time_secs: 0.0, radius: growth(&[[0.0, 1.0]]), start_m: 0.1 },
        ],
        strokes: vec![Brush {
            path: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]],
            during_secs: [1.0, 3.0],
            radius: growth(&[[0.0, 0.3]]),
            start_m: 0.1 * 0.3,
        }],
        cells: Some(Cells {
            center: [0.0, 1.0, 0.0],
            size: [4.0, 2.0, 3.0],
            cell_m: 0.5,
            depth_m: 0.04,
            speed_m_per_s: 3.0,
            uneven: 0.1,
        }),
        pours: vec![Pour { at: [0.0, 2.0, 0.0], during_secs: [0.5, 4.0], rate_m3_per_s: 0.1 }],
        stains: vec![Stain { from: 0, size: 1.5, ends: true, every: 2, rooms: rooms.clone() }],
        spread: Spread {
            subdivisions: 4,
            stiffness: 9.0,
            elasticity: 7.0,
            friction: 0.5,
            gravity: [0.0, -1.0, 0.0],
            grain: 0.3,
            grain_m: 0.7,
        },
        keep: Some([[0.0, 1.0, 0.0], [9.0, 8.0, 7.0]]),
        wash: Some(Wash { steps: 2, spacing: 0.25, colour: srgb(0x3060c0), strength: 0.6, covers: true }),
        border: Some(Border { colour: srgb(0x101418), width: Width::Px(3.0) }),
        inside: Look::Monochrome,
        outside: paint.outside.clone(),
    };
    assert_eq!(*paint, expected);
    // Two drops, two pieces, 8 by 6 cells and stains, in two washes of 162 vertices.
    let volumes = 2 * (52 + rooms.iter().map(StainRoom::volumes).sum::<u64>());
    assert_eq!((paint.volumes(), paint.vertices()), (volumes, volumes * 162));
    assert_eq!(scene.styled_looks().count(), 1);
}

#[test]
fn a_radius_changes_evenly_from_point_to_point() {
    let growth = Growth { points: vec![[1.0, 2.0], [3.0, 4.0], [4.0, 0.0]] };
    let radii = [0.0, 1.0, 2.0, 3.0, 3.5, 4.0, 99.0].map(|secs| growth.at(secs));
    assert_eq!(radii, [2.0, 2.0, 3.0, 4.0, 2.0, 0.0, 0.0]);
    assert_eq!(growth.largest(), 4.0);
}

#[test]
fn there_is_room_for_as_many_stains_as_should_stay() {
    assert_eq!(StainRoom::new(100, 3, 120), StainRoom { particles: 34, rounds: 4 });
    assert_eq!(
        StainRoom::new(100, 1, 7),
        StainRoom { particles: 100, rounds: 1 },
        "a place for each at least"
    );
    assert_eq!(StainRoom::new(0, 1, 7).volumes(), 7);
}

#[test]
fn stiff_paint_takes_smaller_steps() {
    let spread = |stiffness, friction| Spread {
        subdivisions: 4,
        stiffness,
        elasticity: 0.0,
        friction,
        gravity: [0.0; 3],
        grain: 0.0,
        grain_m: 1.0,
    };
    let substeps = |stiffness, friction| spread(stiffness, friction).substeps(1.0 / 24.0);
    assert_eq!((substeps(16.0, 1.0), substeps(1600.0, 1.0), substeps(1600.0, 3.0)), (1, 7, 20));
    assert_eq!(spread(16.0, 0.5).damping_per_s(), 4.0);
}

#[test]
fn every_key_of_a_style_reaches_it() {
    let scene = good(include_str!("good/everything.toml"));
    let fire = &scene.objects[0];
    let puffs = fire.shape.puffs().unwrap();
    assert_eq!((fire.visible, fire.opacity, puffs.variants, puffs.tile_px), (false, 0.5, 8, 64));
    let style = &fire.style;
    assert!(!style.ink.on, "the object's own style");
    let white = Colour { linear: [1.0; 3] };
    let tones = vec![Tone { colour: srgb(0x8fa3b8), from: 0.0 }, Tone { colour: white, from: 0.4 }];
    assert_eq!(style.ramp, Ramp::Tones(tones));
    assert_eq!([style.form, style.form_scale, style.wrap], [0.5, 2.0, 0.1]);
    assert_eq!((style.clean_px, style.height_px, style.shading), (3.0, 360.0, Shading::PerPixel));
    let ink = &style.ink;
    assert_eq!((ink.colour, ink.width), (srgb(0x101418), Width::World(0.05)));
    assert_eq!([ink.offset, ink.inner, ink.lit_thinning, ink.shortest], [0.7, 0.5, 0.3, 2.0]);
    assert_eq!([style.shadow.reach, style.shadow.start, style.shadow.size], [5.0, 0.4, 0.9]);
}

#[test]
fn every_way_to_shade_reaches_the_style() {
    let scene = good(include_str!("good/everything.toml"));
    let style = &scene.objects[0].style;
    assert_eq!(style.material_steps, 6);
    assert_eq!(style.highlight, Highlight { on: true, colour: srgb(0xfffbe8), from: 0.8, gloss: 25.0 });
    assert_eq!(style.rim, Rim { on: true, colour: srgb(0xffe0a0), width: 0.3, from: 0.1 });
    assert_eq!(style.exaggerate, Exaggerate { amount: 0.5, scales: 4, contrast: 3.0 });
    assert!(!style.suits_sprites());
}

#[test]
fn every_key_of_hatching_reaches_the_style() {
    let scene = good(include_str!("good/everything.toml"));
    let expected = Hatching {
        on: true,
        colour: srgb(0x20_3040),
        width: Width::Px(2.0),
        spacing: Width::World(0.1),
        from: 0.9,
        full: 0.1,
        swell: 0.5,
        levels: 5,
        layers: 3,
        cross_deg: 45.0,
        along: Along::Shade,
        angle_deg: 10.0,
        tilt_deg: 20.0,
        follow: Follow::Object,
        length_px: 50.0,
        gaps: 0.2,
        wobble_px: 1.0,
        tooth: 0.3,
        smooth_px: 4.0,
    };
    assert_eq!(scene.objects[0].style.hatching, expected);
}

#[test]
fn naming_hatching_switches_it_on() {
    let all = styles("hatching = {}", &["", "hatching = { on = false }", "preset = \"flat\""]);
    assert_eq!(all.iter().map(|style| style.hatching.on).collect::<Vec<_>>(), [true, false, false]);
    assert!(!all[0].suits_sprites() && all[1].suits_sprites());
}

/// The styles of the objects that are styled so, one after the other.
fn styles(scene_style: &str, objects: &[&str]) -> Vec<Style> {
    let objects: String = objects
        .iter()
        .enumerate()
        .map(|(i, style)| {
            format!("{{ name = \"{i}\", kind = \"cloud\", particles = \"a.ply\", style = {{ {style} }} }}, ")
        })
        .collect();
    let scene = good(&format!(
        "format = 1\ncamera = {{ eye = [0, 0, 5], target = [0, 0, 0] }}\n\
         light = [{{ kind = \"sun\", direction = [0, -1, 0] }}]\nstyle = {{ {scene_style} }}\nobject = [{objects}]"
    ));
    scene.objects.into_iter().map(|object| object.style).collect()
}

#[test]
fn ramps_may_have_rows() {
    let ramps = [
        "ramp = \"a.png\"",
        "ramp = { image = \"a.png\" }",
        "ramp = { image = \"a.png\", rows = { depth = [2, 20] } }",
        "ramp = { image = \"a.png\", rows = { facing = 2 } }",
        "ramp = { image = \"a.png\", rows = { focus = { center = [1, 2, 3], radius = [0, 4] } } }",
    ];
    let expected = [
        RampRows::Middle,
        RampRows::Middle,
        RampRows::Depth([2.0, 20.0]),
        RampRows::Facing(2.0),
        RampRows::Focus { center: [1.0, 2.0, 3.0], radius: [0.0, 4.0] },
    ];
    for (style, rows) in styles("", &ramps).into_iter().zip(expected) {
        assert_eq!(style.ramp, Ramp::Image(RampImage { path: "a.png".into(), rows }));
        assert_eq!(style.suits_sprites(), rows == RampRows::Middle);
    }
}

#[test]
fn steps_mix_in_linear_light() {
    let style = styles("tones = { dark = \"#203040\", light = [1, 0.5, 0.25], steps = 5 }", &[""]).remove(0);
    let Ramp::Tones(tones) = style.ramp else { panic!("these are tones") };
    assert_eq!(tones.iter().map(|tone| tone.from).collect::<Vec<_>>(), [0.0, 0.2, 0.4, 0.6, 0.8]);
    assert_eq!(tones[0].colour, srgb(0x203040));
    assert_eq!(tones[4].colour.linear, [1.0, 0.5, 0.25]);
    let [dark, middle, light] = [0, 2, 4].map(|step| tones[step].colour.linear);
    for channel in 0..3 {
        assert!((2.0 * middle[channel] - dark[channel] - light[channel]).abs() < 1e-6);
    }
}

#[test]
fn shadings_are_laid_over_each_other() {
    let scene = "gooch = { cool = \"#102030\" }, highlight = { gloss = 9 }, exaggerate = { amount = 0.5 }";
    let all = styles(
        scene,
        &[
            "",
            "gooch = { beta = 0.4 }, highlight = { from = 0.5 }, exaggerate = { scales = 2 }",
            "tones = [\"#ffffff\"], highlight = { on = false }, exaggerate = { amount = 0 }",
        ],
    );
    let gooch = Gooch { cool: srgb(0x102030), ..Gooch::default() };
    assert_eq!(all[0].ramp, Ramp::Gooch(gooch));
    assert_eq!(all[0].highlight, Highlight { on: true, gloss: 9.0, ..Highlight::default() });
    assert_eq!(all[1].ramp, Ramp::Gooch(Gooch { beta: 0.4, ..gooch }));
    assert_eq!((all[1].highlight.gloss, all[1].highlight.from), (9.0, 0.5));
    assert_eq!((all[1].exaggerate.amount, all[1].exaggerate.scales), (0.5, 2));
    assert!(!all[2].highlight.on && all[2].suits_sprites());
}

#[test]
fn every_key_of_smoke_reaches_it() {
    let scene = good(include_str!("good/everything.toml"));
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
    let scene = good(include_str!("good/everything.toml"));
    let costs = scene.requirements();
    // 60 a second for 2 s and a step, one for rounding, the larger burst, and 500 kept alive.
    let particles = (60.0_f64 * (2.0 + 1.0 / 48.0)).ceil() as u64 + 1 + 100 + 500;
    assert_eq!((costs[0].particles, costs[0].state_bytes), (Some(particles), Some(particles * 96)));
    assert_eq!(costs[1].particles, None, "only the file knows");
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
    let toml = include_str!("good/everything.toml");
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
fn a_chosen_style_takes_the_place_of_the_scenes() {
    let toml = include_str!("good/cumulus.toml");
    let overrides = [set("style.form", "0.25")];
    let load = |style| {
        let text = SceneText { name: "scene.toml", toml, set: &overrides, style: Some(style) };
        load_with(&text, &[]).unwrap().0.objects.remove(0).style
    };
    let preset = load(StyleChoice::Preset("mcguire"));
    assert_eq!(preset.ink.colour, srgb(0), "the scene's ink is gone");
    assert_eq!(preset.form, 0.25, "an override still comes on top");
    let own = "preset = \"flat\"\nramp = \"ramp.png\"\n";
    let file = load(StyleChoice::Text { name: "styles/own.style.toml", toml: own });
    assert_eq!(
        file.ramp,
        Ramp::Image(RampImage { path: "styles/ramp.png".into(), rows: RampRows::Middle }),
        "paths go from the style file"
    );
    assert!(!file.shadow.on);
}

#[test]
fn a_scene_may_name_a_style_file() {
    let toml = "format = 1\ncamera = { eye = [0, 0, 5], target = [0, 0, 0] }\n\
                light = [{ kind = \"sun\", direction = [0, -1, 0] }]\n\
                style = { file = \"my.style.toml\", wrap = 0.5 }\n\
                object = [{ name = \"a\", kind = \"cloud\", particles = \"a.ply\" }]";
    let text = SceneText { name: "scene.toml", toml, ..SceneText::default() };
    let (scene, report) = load_with(&text, &[("my.style.toml", "form = 0.9\nwrap = 0.1\n")]).unwrap();
    assert!(report.is_empty(), "{report}");
    let style = &scene.objects[0].style;
    assert_eq!([style.form, style.wrap], [0.9, 0.5]);
}

#[test]
fn every_preset_loads() {
    for preset in fumetto_scene::presets::names() {
        let toml = include_str!("good/cumulus.toml");
        let style = Some(StyleChoice::Preset(preset));
        let text = SceneText { name: "scene.toml", toml, style, ..SceneText::default() };
        let (_, report) = load_with(&text, &[]).unwrap();
        assert!(report.is_empty(), "{preset}: {report}");
    }
}

#[test]
fn every_preset_tells_what_it_is_for() {
    let every = || fumetto_scene::presets::groups().iter().flat_map(|group| group.presets);
    for preset in every() {
        let about = preset.about();
        assert!(about.ends_with('.') && about.starts_with(char::is_uppercase), "{}: {about:?}", preset.name);
        assert_eq!(every().filter(|other| other.name == preset.name).count(), 1, "{}", preset.name);
    }
    assert_eq!(fumetto_scene::presets::names().first(), Some(&"cartoon"), "the default comes first");
}

#[test]
fn a_curve_is_linear_between_its_points_and_stays_outside() {
    let curve = Curve { points: vec![[0.2, 1.0], [0.6, 3.0]] };
    let at = [0.0, 0.2, 0.4, 0.6, 1.0].map(|age| curve.at(age));
    let expected = [1.0, 1.0, 2.0, 3.0, 3.0];
    assert!(at.iter().zip(expected).all(|(got, wanted)| (got - wanted).abs() < 1e-6), "{at:?}");
}

#[test]
fn every_8_bit_colour_survives() {
    for level in 0..=255 {
        let srgb = [level, 255 - level, level / 2];
        assert_eq!(Colour::from_srgb8(srgb).to_srgb8(), srgb);
    }
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
fn strokes_begin_with_what_their_texture_brings() {
    let scene = good(
        "format = 1\ncamera = { eye = [0, 1, 5], target = [0, 0, 0] }\n\
         light = [{ kind = \"sun\", direction = [0, -1, 0] }]\n\
         style = { preset = \"sketch\", ink = { stroke = { boil = 4 }, crease = { stroke = { wobble = 0 } }, \
         boundary = { stroke = { texture = \"edge.png\", scale = 2 } }, material = { stroke = { on = false } } } }\n\
         object = [{ name = \"a\", kind = \"cloud\", particles = [{ center = [0, 5, 0], radius = 1 }] }]",
    );
    let ink = &scene.objects[0].style.ink;
    let pencil = Stroke { boil: 4, ..Stroke::of(StrokeTexture::Pencil) };
    assert_eq!(ink.stroke_of(EdgeKind::Silhouette), Some(&pencil));
    assert_eq!(ink.stroke_of(EdgeKind::Crease), Some(&Stroke { wobble: 0.0, ..pencil.clone() }));
    let file = Stroke::of(StrokeTexture::File("edge.png".into()));
    assert_eq!(ink.stroke_of(EdgeKind::Boundary), Some(&Stroke { scale: 2.0, ..file }));
    assert_eq!(ink.stroke_of(EdgeKind::Material), None);
    assert!(scene.objects[0].style.mask && !scene.objects[0].style.suits_sprites());
}

#[test]
fn strokes_have_as_many_pictures_as_fit_an_array() {
    let scene = |kinds: &[&str]| {
        let object = |number: usize| {
            let pen = |kind: &&str| format!("{kind} = {{ stroke = {{ texture = \"{kind}{number}.png\" }} }}");
            let pens = kinds.iter().map(pen).collect::<Vec<_>>().join(", ");
            format!(
                "[[object]]\nname = \"{number}\"\nkind = \"cloud\"\nstyle = {{ ink = {{ {pens} }} }}\n\
                 particles = [{{ center = [0, 5, 0], radius = 1 }}]\n"
            )
        };
        let objects: String = (0..63).map(object).collect();
        load(&format!("format = 1\ncamera = {{ eye = [0, 1, 5], target = [0, 0, 0] }}\n{objects}"))
    };
    let kinds = ["silhouette", "crease", "boundary", "material"];
    assert_eq!(scene(&kinds[1..]).unwrap().0.stroke_pictures().len(), 3 * 63);
    let refused = scene(&kinds).unwrap_err().render(false);
    assert!(refused.contains("252 pictures") && refused.contains("at most 251"), "{refused}");
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
    let toml = include_str!("good/everything.toml");
    let text = SceneText { name: "scene.toml", toml, set: &set, style: None };
    let (scene, _) = load_with(&text, &[]).unwrap();
    let cost = &scene.requirements()[0];
    assert_eq!(cost.surface.map(|room| u64::from(room.particles)), cost.particles);
    assert_eq!(scene.requirements()[1].surface, None);
}

#[test]
fn a_curves_mean_counts_what_lies_outside_its_points() {
    let curve = Curve { points: vec![[0.2, 1.0], [0.6, 3.0]] };
    assert!((curve.mean() - (0.2 + 0.4 * 2.0 + 0.4 * 3.0)).abs() < 1e-6, "{}", curve.mean());
    assert_eq!((curve.largest(), Curve::constant(2.0).mean()), (3.0, 2.0));
}

/// The volume `shape` of a ball of radius 1 and one of 0.5, whose middles are 4 m apart.
fn two_puffs(shape: &str) -> (Volume, Vec<Particle>) {
    let scene = good(&format!(
        "format = 1\ncamera = {{ eye = [0, 1, 5], target = [0, 0, 0] }}\n\
         light = [{{ kind = \"sun\", direction = [0, -1, 0] }}]\n\
         object = [{{ name = \"a\", kind = \"cloud\", shape = {{ volume = {{ {shape} }} }}, particles = [\n\
         {{ center = [0, 5, 0], radius = 1 }}, {{ center = [4, 5, 0], radius = 0.5 }} ] }}]"
    ));
    let Matter::Still(particles) = &scene.objects[0].matter else { panic!("a still cloud") };
    (scene.objects[0].shape.volume().unwrap().clone(), particles.clone())
}

#[test]
fn every_key_of_a_volume_reaches_it() {
    let white = Colour { linear: [1.0; 3] };
    let plain = Volume {
        extinction_per_m: 4.0,
        profile: Profile::Constant,
        edge: 0.0,
        size: 1.0,
        noise: None,
        colours: vec![white],
        glow: 0.0,
        soft: 0.0,
        surface: 0.5,
        relief: 0.5,
        shadow: 0.0,
        cells: 128,
        light_cells: 64,
        step_m: None,
        step_cells: 0.5,
        lobe_m: None,
    };
    assert_eq!(two_puffs("").0, plain);
    let noise = VolumeNoise {
        amplitude: 0.4,
        frequency: 3.0,
        octaves: 6,
        persistence: 0.6,
        lacunarity: 2.5,
        seed: 8,
        drift: [0.0, 0.25, 0.0],
        billow: false,
    };
    let other = Volume {
        extinction_per_m: 9.0,
        profile: Profile::Linear,
        edge: 0.25,
        size: 2.0,
        noise: Some(noise),
        colours: vec![Colour { linear: [1.0, 0.5, 0.0] }, white],
        glow: 0.75,
        soft: 0.5,
        surface: 0.25,
        relief: 1.0,
        shadow: 0.6,
        cells: 50,
        light_cells: 20,
        step_m: Some(0.125),
        step_cells: 0.5,
        lobe_m: None,
    };
    let keys = "extinction = 9, profile = \"linear\", edge = 0.25, size = 2, glow = 0.75, soft = 0.5, \
                surface = 0.25, relief = 1, shadow = 0.6, cells = 100, light_cells = 40, step = 0.125, quality = 0.5, \
                colours = [[1, 0.5, 0], \"#ffffff\"], noise = { amplitude = 0.4, frequency = 3, octaves = 6, \
                persistence = 0.6, lacunarity = 2.5, seed = 8, drift = [0, 0.25, 0], billow = false }";
    assert_eq!(two_puffs(keys).0, other);
    assert!(other.drifts() && !plain.drifts());
}

#[test]
fn every_key_of_a_volume_out_of_a_file_reaches_it() {
    let scene = good(
        r#"
        format = 1
        camera = { eye = [0, 1, 5], target = [0, 0, 0] }
        light = [{ kind = "sun", direction = [0, -1, 0] }]
        [[object]]
        name = "plain"
        kind = "volume"
        volume = "smoke.VDB"
        [[object]]
        name = "smoke"
        kind = "volume"
        up = "z"
        transform = { position = [1, 2, 3], rotation = [0, 90, 0], scale = 2 }
        shape = { volume = { lobe = 0.5, quality = 0.5, light_cells = 40 } }
        [object.volume]
        file = "smoke.####.vdb"
        density = "smoke"
        heat = "flame"
        range = [9, 1]
        heat_range = [300, 2000]
        frames = [2, 9]
        loop = true
        [[object]]
        name = "head"
        kind = "volume"
        [object.volume]
        file = "head.img"
        [object.volume.raw]
        size = [3, 4, 5]
        type = "i16"
        order = "big"
        voxel = [1, 2, 3]
        origin = [4, 5, 6]
        skip = 352
        "#,
    );
    let imported = |index: usize| match &scene.objects[index].matter {
        Matter::Imported(imported) => (**imported).clone(),
        other => panic!("{other:?} is not out of a file"),
    };
    let plain = Imported {
        file: "smoke.VDB".into(),
        density: None,
        heat: None,
        range: None,
        heat_range: [0.0, 1.0],
        frames: None,
        repeats: false,
        raw: None,
        z_up: false,
        place: Transform::default(),
    };
    assert_eq!(imported(0), plain);
    let smoke = Imported {
        file: "smoke.####.vdb".into(),
        density: Some("smoke".into()),
        heat: Some("flame".into()),
        range: Some([9.0, 1.0]),
        heat_range: [300.0, 2000.0],
        frames: Some([2, 9]),
        repeats: true,
        raw: None,
        z_up: true,
        place: Transform { position: [1.0, 2.0, 3.0], rotation_deg: [0.0, 90.0, 0.0], scale: [2.0; 3] },
    };
    assert_eq!(imported(1), smoke);
    let raw = Raw {
        size: [3, 4, 5],
        number: RawNumber::I16,
        big_endian: true,
        voxel_m: [1.0, 2.0, 3.0],
        origin_m: [4.0, 5.0, 6.0],
        skip: 352,
    };
    assert_eq!(imported(2), Imported { file: "head.img".into(), raw: Some(raw), ..plain });
    let volume = |index: usize| scene.objects[index].shape.volume().unwrap();
    assert_eq!((volume(0).light_cells, volume(0).step_cells, volume(0).lobe_m), (64, 0.5, None));
    assert_eq!((volume(1).light_cells, volume(1).step_cells, volume(1).lobe_m), (20, 1.0, Some(0.5)));
}

#[test]
fn a_volumes_grids_fit_its_puffs() {
    let room = |keys: &str| {
        let (volume, particles) = two_puffs(keys);
        volume.room(&particles)
    };
    // From -1 to 4.5 along x, 2 m along y and z; 3 cells lie around them.
    let plain = room("cells = 100, light_cells = 50");
    assert_eq!((plain.cells, plain.light_cells), ([100, 39, 39], [50, 20, 20]));
    assert_eq!(plain.bytes(), 100 * 39 * 39 * 12 + 50 * 20 * 20 * 8);
    // Noise reaches as far again: 7 m by 4 m.
    assert_eq!(room("cells = 103, noise = { amplitude = 1 }").cells, [103, 61, 61]);
    assert_eq!(two_puffs("cells = 20").0.moving_room().cells, [20; 3]);
    assert!(two_puffs("").0.room(&[]).fits(), "nothing is no reason to fail");
}

#[test]
fn the_cost_of_a_volume_is_told_beforehand() {
    let set = [set("object.fire.shape", "{ volume = { cells = 100, light_cells = 50 } }")];
    let toml = include_str!("good/everything.toml");
    let text = SceneText { name: "scene.toml", toml, set: &set, style: None };
    let (scene, _) = load_with(&text, &[]).unwrap();
    let cost = &scene.requirements()[0];
    assert_eq!(cost.volume.map(|room| room.bytes()), Some(1_000_000 * 12 + 125_000 * 8));
    assert_eq!(scene.requirements()[1].volume, None);
}
