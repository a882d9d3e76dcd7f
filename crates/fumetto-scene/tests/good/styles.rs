//! Styles: ramps, shadings, hatching, strokes, and where styles come from.

use super::{
    common::{load, load_with},
    good, set, srgb,
};
use fumetto_scene::{
    Along, Colour, EdgeKind, Exaggerate, Follow, Gooch, Hatching, Highlight, Ramp, RampImage, RampRows, Rim,
    SceneText, Shading, Stroke, StrokeTexture, Style, StyleChoice, Tone, Width,
};

#[test]
fn every_key_of_a_style_reaches_it() {
    let scene = good(include_str!("everything.toml"));
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
    let scene = good(include_str!("everything.toml"));
    let style = &scene.objects[0].style;
    assert_eq!(style.material_steps, 6);
    assert_eq!(style.highlight, Highlight { on: true, colour: srgb(0xfffbe8), from: 0.8, gloss: 25.0 });
    assert_eq!(style.rim, Rim { on: true, colour: srgb(0xffe0a0), width: 0.3, from: 0.1 });
    assert_eq!(style.exaggerate, Exaggerate { amount: 0.5, scales: 4, contrast: 3.0 });
    assert!(!style.suits_sprites());
}

#[test]
fn every_key_of_hatching_reaches_the_style() {
    let scene = good(include_str!("everything.toml"));
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
fn a_chosen_style_takes_the_place_of_the_scenes() {
    let toml = include_str!("cumulus.toml");
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
        let toml = include_str!("cumulus.toml");
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
