//! Bad scenes are refused with messages that say where, what and how else.
//!
//! The messages are reviewed as snapshots: `tests/snapshots/bad__NAME.snap` for `tests/bad/NAME.toml`.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod common;

use std::path::Path;

use common::load_with;
use fumetto_scene::{Report, Scene, SceneText, Severity, StyleChoice};

const BROKEN_STYLE: &str = "form = 2\nfile = \"other.style.toml\"\nink = { wdth = { px = 1 } }\n";

fn report(result: Result<(Scene, Report), Report>) -> Report {
    match result {
        Ok((_, warnings)) => warnings,
        Err(report) => {
            assert!(report.count(Severity::Error) > 0, "a refusal needs a reason");
            report
        }
    }
}

#[test]
fn every_bad_scene_is_explained() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    assert!(paths.len() > 30, "the folder of bad scenes is there");
    for path in paths {
        let toml = std::fs::read_to_string(&path).unwrap();
        let name = path.file_name().unwrap().to_str().unwrap();
        let text = SceneText { name, toml: &toml, ..SceneText::default() };
        let report = report(load_with(&text, &[("broken.style.toml", BROKEN_STYLE)]));
        assert!(!report.is_empty(), "{name} has nothing wrong");
        insta::assert_snapshot!(path.file_stem().unwrap().to_str().unwrap(), report.render(false));
    }
}

#[test]
fn bad_overrides_are_explained() {
    let overrides: Vec<(String, String)> = [
        ("camera.fov", "wide"),
        ("camera.eye[3]", "1"),
        ("camera.eye[x]", "1"),
        ("camera[1].fov", "30"),
        ("camera..fov", "30"),
        ("camera.fov.deg", "30"),
        ("", "1"),
        ("object.cumulos.opacity", "0.5"),
        ("object.cumulus.opacity", "1.5"),
        ("style.ink.colr", "#000000"),
        ("style.tones", "[\"#000000\", \"#ggffff\"]"),
        ("nothing[0].x", "1"),
    ]
    .iter()
    .map(|(path, value)| ((*path).to_owned(), (*value).to_owned()))
    .collect();
    let toml = include_str!("good/cumulus.toml");
    let text = SceneText { name: "scene.toml", toml, set: &overrides, ..SceneText::default() };
    insta::assert_snapshot!("overrides", report(load_with(&text, &[])).render(false));
}

#[test]
fn bad_style_choices_are_explained() {
    let toml = include_str!("good/cumulus.toml");
    let render = |style| {
        let text = SceneText { name: "scene.toml", toml, style: Some(style), ..SceneText::default() };
        report(load_with(&text, &[])).render(false)
    };
    insta::assert_snapshot!("style_choice_preset", render(StyleChoice::Preset("mcgiure")));
    let text = StyleChoice::Text { name: "my.style.toml", toml: BROKEN_STYLE };
    insta::assert_snapshot!("style_choice_text", render(text));
}

#[test]
fn colour_adds_escapes_only() {
    let toml = include_str!("bad/zero_radius.toml");
    let report = common::load(toml).unwrap_err();
    let coloured = report.render(true);
    assert!(coloured.contains("\u{1b}["));
    assert!(!report.render(false).contains('\u{1b}'));
}

#[test]
fn positions_count_lines_and_characters_from_one() {
    let toml = include_str!("bad/unicode.toml");
    let report = common::load(toml).unwrap_err();
    let problem = &report.problems()[0];
    assert_eq!((problem.code, report.position(problem)), ("bad-colour", Some((6, 21))));
}

#[test]
fn a_flood_of_problems_is_cut_short() {
    let particles = "{ center = [0, 0, 0], radius = 0 },\n".repeat(5000);
    let toml = format!(
        "format = 1\ncamera = {{ eye = [0, 0, 1], target = [0, 0, 0] }}\n\
         object = [{{ name = \"a\", kind = \"cloud\", particles = [\n{particles}] }}]"
    );
    let report = common::load(&toml).unwrap_err();
    assert!(report.problems().len() <= 200);
    assert_eq!(report.count(Severity::Error) + report.left_out(), 5000);
}

/// Everything here is linear in the text: a million particles load in seconds, and so does nonsense.
#[test]
fn long_scenes_are_read_in_linear_time() {
    let start = std::time::Instant::now();
    let head = "format = 1\ncamera = { eye = [0, 0, 1], target = [0, 0, 0] }\n";
    let particles = "{ center = [0, 0, 0], radius = 1 },\n".repeat(100_000);
    let cloud = format!("{head}object = [{{ name = \"a\", kind = \"cloud\", particles = [\n{particles}] }}]");
    assert!(common::load(&cloud).is_ok());
    let keys: String = (0..100_000).map(|i| format!("key{i} = 1\n")).collect();
    assert!(common::load(&format!("{head}{keys}")).is_err());
    let objects: String = (0..20_000)
        .map(|i| format!("[[object]]\nname = \"{i}\"\nkind = \"cloud\"\nstyle = {{ preset = \"flat\" }}\n"))
        .collect();
    assert!(common::load(&format!("{head}{objects}")).is_err());
    assert!(start.elapsed().as_secs() < 30, "{:?}", start.elapsed());
}
