//! What an inspector shows is all that a scene can say, and what it offers is what a scene may say.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod common;

use std::collections::BTreeSet;

use fumetto_scene::edit::form::{Field, Form, Kind};
use fumetto_scene::edit::{Document, Edit, Path, Value};

fn path(text: &str) -> Path {
    text.parse().unwrap()
}

fn document(objects: &str) -> Document {
    let head = "format = 1\n[camera]\neye = [0, 1, 5]\ntarget = [0, 0, 0]\n[[light]]\nkind = \"sun\"\ndirection = [0, -1, 0]\n";
    Document::open(format!("{head}{objects}")).unwrap()
}

/// What would keep the text from being read; what it means is another matter.
fn misfits(document: &Document) -> Vec<String> {
    const MISFITS: [&str; 10] = [
        "syntax",
        "wrong-type",
        "wrong-length",
        "missing-key",
        "unknown-key",
        "unknown-value",
        "out-of-range",
        "not-finite",
        "conflicting-keys",
        "bad-colour",
    ];
    match common::load(document.text()) {
        Ok(_) => Vec::new(),
        Err(report) => {
            let problems = report.problems().iter().filter(|problem| MISFITS.contains(&problem.code));
            problems.map(|problem| format!("{}: {}", problem.code, problem.message)).collect()
        }
    }
}

/// Goes through all forms below `path`, and through all that they offer.
fn walk(document: &Document, path: &Path, depth: usize, seen: &mut BTreeSet<String>) {
    assert!(depth < 12, "no end: {path}");
    let Some(form) = Form::at(document, path) else { panic!("no form at {path}\n{}", document.text()) };
    for field in &form.fields {
        let what = field.path.to_string();
        let key = what.rsplit('.').next().unwrap().to_owned();
        seen.insert(key);
        assert!(!field.label.is_empty() && !field.docs.summary.is_empty(), "{what}");
        assert_eq!(Field::at(document, &field.path).as_ref(), Some(field), "{what}");
        visit(&started(document, field), &field.path, &field.kind, depth, seen);
    }
}

/// The document with what a field begins with, unless it has something there.
fn started(document: &Document, field: &Field) -> Document {
    let mut changed = document.clone();
    if !field.is_set {
        changed.apply(&Edit::Set { path: field.path.clone(), value: field.start.clone() }).unwrap();
        assert_eq!(misfits(&changed), [""; 0], "{} = {}\n{}", field.path, field.start, changed.text());
    }
    changed
}

fn visit(document: &Document, path: &Path, kind: &Kind, depth: usize, seen: &mut BTreeSet<String>) {
    let with = |value: &Value| {
        let mut changed = document.clone();
        changed.apply(&Edit::Set { path: path.clone(), value: value.clone() }).unwrap();
        assert_eq!(misfits(&changed), [""; 0], "{path} = {value}\n{}", changed.text());
        changed
    };
    match kind {
        Kind::Table => walk(document, path, depth + 1, seen),
        Kind::List { item, start, len: None, .. } => {
            let changed = with(&Value::Array(vec![start.clone()]));
            let element = Field::at(&changed, &path.index(0)).unwrap();
            assert_eq!(&element.kind, &**item, "{path}");
            visit(&changed, &path.index(0), item, depth + 1, seen);
        }
        Kind::Union(alternatives) => {
            for (index, alternative) in alternatives.iter().enumerate() {
                let changed = with(&alternative.start);
                let field = Field::at(&changed, path).unwrap();
                assert_eq!(field.present, Some(index), "{path} = {}", alternative.start);
                match &alternative.key {
                    Some(key) => visit(&changed, &path.key(key), &alternative.kind, depth + 1, seen),
                    None => visit(&changed, path, &alternative.kind, depth + 1, seen),
                }
            }
        }
        _ => {}
    }
}

#[test]
fn all_that_is_offered_fits() {
    let mut seen = BTreeSet::new();
    for kind in ["smoke", "cloud", "mesh", "volume", "paint"] {
        let document = document(&format!("[[object]]\nname = \"a\"\nkind = \"{kind}\"\n"));
        walk(&document, &path("object[0]"), 0, &mut seen);
    }
    let form = Form::at(&document(""), &Path::root()).unwrap();
    for field in form.fields.iter().filter(|field| field.path != path("object")) {
        visit(&started(&document(""), field), &field.path, &field.kind, 0, &mut seen);
        seen.insert(field.path.to_string());
    }
    seen.insert("object".to_owned());
    let mut all = BTreeSet::new();
    keys(&fumetto_scene::schema(), &mut all);
    all.remove("kind");
    let missing: Vec<_> = all.difference(&seen).collect();
    // The only keys of a union's tables are the names of its alternatives.
    let unions = [
        "box", "depth", "disc", "facing", "focus", "line", "point", "px", "puffs", "sphere", "surface",
        "volume", "world",
    ];
    assert!(missing.iter().all(|key| unions.contains(&key.as_str())), "{missing:?}");
}

fn keys(schema: &serde_json::Value, found: &mut BTreeSet<String>) {
    match schema {
        serde_json::Value::Object(entries) => {
            let properties = schema["properties"].as_object();
            found.extend(properties.into_iter().flat_map(|keys| keys.keys().cloned()));
            entries.values().for_each(|inner| keys(inner, found));
        }
        serde_json::Value::Array(items) => items.iter().for_each(|inner| keys(inner, found)),
        _ => {}
    }
}

#[test]
fn a_form_knows_what_is_and_what_would_be() {
    let scene = document(
        "[style]\npreset = \"pencil\"\nform = 0.25\n[[object]]\nname = \"a\"\nkind = \"cloud\"\nopacity = 0.5\n\
         style = { tones = [\"#A0B0c0\", \"#ffffff\"], ink = { width = { world = 0.1 } } }\n",
    );
    let form = Form::at(&scene, &path("object.a")).unwrap();
    assert!(form.field("particles").is_some() && form.field("emitter").is_none());
    let opacity = form.field("opacity").unwrap();
    assert_eq!((opacity.value.clone(), opacity.default.clone()), (Some(0.5.into()), Some(1.0.into())));
    let Kind::Number { range, unit: "" } = opacity.kind else { panic!("{:?}", opacity.kind) };
    assert!(range.contains(1.0) && !range.contains(1.1));
    let style = Form::at(&scene, &path("object.a.style")).unwrap();
    assert_eq!(style.field("form").unwrap().default, Some(0.25.into()), "from the scene's style");
    let tones = style.field("tones").unwrap();
    let Kind::Union(shapes) = &tones.kind else { panic!("{:?}", tones.kind) };
    assert_eq!(shapes[tones.present.unwrap()].kind, Kind::Ramp);
    assert_eq!(tones.value.as_ref().unwrap()[0].as_str(), Some("#A0B0c0"));
    let width = Field::at(&scene, &path("object.a.style.ink.width")).unwrap();
    let Kind::Union(shapes) = &width.kind else { panic!("{:?}", width.kind) };
    let world = &shapes[width.present.unwrap()];
    assert_eq!((world.key.as_deref(), world.docs.summary.as_str()), (Some("world"), "In metres, above 0."));
    assert!(matches!(world.kind, Kind::Number { unit: "m", .. }));
    let fov = Field::at(&scene, &path("camera.fov")).unwrap();
    assert!(matches!(fov.kind, Kind::Number { unit: "°", .. }) && fov.default == Some(40.0.into()));
    let preset = Field::at(&scene, &path("style.preset")).unwrap();
    assert!(matches!(preset.kind, Kind::Choice(words) if words.iter().any(|word| word.word == "pencil")));
    assert!(Field::at(&scene, &path("camera.zoom")).is_none() && Form::at(&scene, &path("seed")).is_none());
}

#[test]
fn switching_keeps_what_both_have() {
    let scene = document("");
    let light = Field::at(&scene, &path("light[0]")).unwrap();
    assert_eq!(light.present, Some(0));
    let sun: toml::Table = "kind = \"sun\"\ndirection = [0, -1, 0]\nintensity = 0.3".parse().unwrap();
    let point = light.switched(1, Some(&Value::Table(sun))).unwrap();
    assert_eq!(point["kind"].as_str(), Some("point"));
    assert!(point.get("position").is_some() && point.get("direction").is_none());
    let smoke = document(
        "[[object]]\nname = \"a\"\nkind = \"smoke\"\n[object.emitter]\nshape = { sphere = { center = [1, 2, 3], radius = 0.7 } }\n",
    );
    let at = path("object[0].emitter.shape");
    let shape = Field::at(&smoke, &at).unwrap();
    let disc = shape.switched(1, smoke.get(&at).as_ref()).unwrap();
    assert_eq!(disc["disc"]["radius"].as_float(), Some(0.7));
    assert_eq!(disc["disc"]["center"][1].as_integer(), Some(2), "{disc}");
    let growth = Field::at(&smoke, &path("object[0].emitter.radius_over_life")).unwrap();
    let curve = growth.switched(1, Some(&2.into())).unwrap();
    assert_eq!(curve.to_string(), "[[0.0, 2], [1.0, 2]]");
    assert_eq!(growth.switched(0, Some(&curve)), Some(2.into()));
}
