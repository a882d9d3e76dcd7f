//! Edits change a scene's text as a careful hand would.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use fumetto_scene::edit::{Document, Edit, EditError, Item, Path, Step, Value};
use fumetto_scene::{Scene, SceneText};

fn path(text: &str) -> Path {
    text.parse().unwrap()
}

fn value(toml: &str) -> Value {
    toml::from_str::<toml::Table>(&format!("v = {toml}")).unwrap().remove("v").unwrap()
}

fn set(at: &str, toml: &str) -> Edit {
    Edit::Set { path: path(at), value: value(toml) }
}

fn insert(list: &str, index: usize, toml: &str) -> Edit {
    Edit::Insert { list: path(list), index, item: Item::Value(value(toml)) }
}

/// The text after `edit`, and that undo brings back what was.
fn after(text: &str, edit: &Edit) -> String {
    let mut document = Document::open(text).unwrap();
    document.apply(edit).unwrap();
    let changed = document.text().to_owned();
    assert_eq!(document.undo(), changed != text);
    assert_eq!(document.text(), text);
    changed
}

#[test]
fn values_are_set_where_they_stand() {
    let scene = "[camera] # the only one\neye = [0, 1.5, 6]   # metres\nfov = 40\ncolour = \"#A0b0C0\"\n";
    for (at, toml, line) in [
        ("camera.fov", "35.0", "fov = 35"),
        ("camera.fov", "35.5", "fov = 35.5"),
        ("camera[0].fov", "30", "fov = 30"),
        ("camera.eye[1]", "2", "eye = [0, 2.0, 6]   # metres"),
        ("camera.eye", "[0.0, 1.5, 7.0]", "eye = [0, 1.5, 7]   # metres"),
        ("camera.colour", "\"#A0b0C1\"", "colour = \"#A0b0C1\""),
        ("camera.colour", "[0.5, 0.25, 1.0]", "colour = [0.5, 0.25, 1.0]"),
        ("camera.near", "0.1", "\"\nnear = 0.1\n"),
        ("camera.lens.name", "\"a\\\"b\"", "\nlens = { name = 'a\"b' }\n"),
    ] {
        let text = after(scene, &set(at, toml));
        assert!(text.contains(line), "{at} = {toml}:\n{text}");
        assert!(text.contains("# metres") && text.contains("# the only one"), "{text}");
    }
    for (at, toml) in
        [("camera.fov", "40.0"), ("camera.eye", "[0.0, 1.5, 6.0]"), ("camera", "{}")].iter().take(2)
    {
        assert_eq!(after(scene, &set(at, toml)), scene, "the present value is no step");
    }
}

#[test]
fn numbers_are_written_short() {
    let scene = "a = 1.0\n";
    for (number, written) in [(0.1_f32, "0.1"), (1e30, "1e30"), (-2.0, "-2.0"), (1.0 / 3.0, "0.33333334")] {
        let edit = Edit::Set { path: path("a"), value: Value::Float(number.into()) };
        assert_eq!(after(scene, &edit), format!("a = {written}\n"));
    }
}

#[test]
fn what_is_missing_is_made_as_by_hand() {
    let scene = "format = 1\n\n# Light.\n[[light]]\nkind = \"sun\"\n\n# A puff.\n[[object]]\nname = \"a\"\nink = { width = { px = 2.0 } }\n";
    let text = after(scene, &set("style.ink.width", "{ px = 3.0 }"));
    assert_eq!(text, scene.replace("# A puff.", "[style]\nink = { width = { px = 3.0 } }\n\n# A puff."),);
    let text = after(scene, &set("object.a.ink.width", "{ world = 0.1 }"));
    assert_eq!(text, scene.replace("px = 2.0", "world = 0.1"));
    let text = after(scene, &set("object[0].ink.colour", "\"#000000\""));
    assert_eq!(text, scene.replace("2.0 } }", "2.0 }, colour = \"#000000\" }"));
    let text = after(scene, &set("seed", "7"));
    assert_eq!(text, scene.replace("format = 1\n", "format = 1\nseed = 7\n"));
    let text = after(scene, &insert("object.a.force", 0, "{ kind = \"drag\", rate = 2 }"));
    assert_eq!(text, format!("{scene}\n[[object.force]]\nkind = \"drag\"\nrate = 2\n"));
    let text = after(scene, &insert("camera", 0, "{ eye = [0, 0, 1] }"));
    assert_eq!(text, scene.replace("# Light.", "[[camera]]\neye = [0, 0, 1]\n\n# Light."));
    assert_eq!(after("", &set("seed", "7")), "seed = 7\n");
    assert_eq!(after("# A scene.\n", &set("seed", "7")), "# A scene.\nseed = 7\n");
    assert_eq!(after("a.b = 1", &set("a.c", "2")), "a.b = 1\na.c = 2");
    assert_eq!(after("x = { a.b = 1 }\n", &set("x.a.c", "2")), "x = { a.b = 1, a.c = 2 }\n");
    assert_eq!(after("[a.b]\nc = 1\n", &set("a.d", "2")), "[a]\nd = 2\n\n[a.b]\nc = 1\n");
    assert_eq!(after("a = 1\r\n", &set("b", "2")), "a = 1\r\nb = 2\r\n");
}

#[test]
fn what_is_removed_leaves_the_rest_alone() {
    let remove = |text: &str, at: &str| after(text, &Edit::Remove { path: path(at) });
    assert_eq!(remove("a = 1\n# about b\nb = 2 # two\nc = 3\n", "b"), "a = 1\n# about b\nc = 3\n");
    assert_eq!(remove("x = { a = 1, b = 2, c = 3 }\n", "x.a"), "x = { b = 2, c = 3 }\n");
    assert_eq!(remove("x = { a = 1, b = 2, c = 3 }\n", "x.c"), "x = { a = 1, b = 2 }\n");
    assert_eq!(remove("x = [1, 2, 3]\n", "x[1]"), "x = [1, 3]\n");
    assert_eq!(remove("x = [1, 2, 3,]\n", "x[2]"), "x = [1, 2,]\n");
    assert_eq!(remove("x = [1,]\n", "x[0]"), "x = []\n");
    let lines = "x = [\n  1, # one\n  # above two\n  2, # two\n  3 # three\n]\n";
    assert_eq!(remove(lines, "x[1]"), "x = [\n  1, # one\n  3 # three\n]\n");
    assert_eq!(remove(lines, "x[2]"), "x = [\n  1, # one\n  # above two\n  2, # two\n]\n");
    let tables = "[[a]]\nn = 1\n[[a.b]]\nm = 1\n\n# Two.\n[[a]]\nn = 2\n\n[c]\n";
    assert_eq!(remove(tables, "a[0]"), "\n# Two.\n[[a]]\nn = 2\n\n[c]\n");
    assert_eq!(remove(tables, "a[1]"), "[[a]]\nn = 1\n[[a.b]]\nm = 1\n\n[c]\n");
    assert_eq!(remove("a.b = 1\na.c = 2\nd = 3\n", "a"), "\nd = 3\n");
    assert_eq!(remove("a = 1\n", "nothing.here"), "a = 1\n");
}

#[test]
fn a_table_without_a_header_gets_one() {
    for (scene, toml, whole) in [
        ("[a.b.c]\nk = 1\n", "{ a = 0, b = 0 }", "[a]\na = 0\nb = 0\n"),
        ("[a.b]\nk = 1\n\n[a.c]\n", "{ b = 1, c = 2 }", "[a]\nb = 1\nc = 2\n"),
        ("[a.b] # one\nk = 1\n", "{ b = { k = 1 }, d = 2 }", "[a]\nd = 2\n\n[a.b] # one\nk = 1\n"),
    ] {
        assert_eq!(after(scene, &set("a", toml)).trim_end(), whole.trim_end());
    }
}

#[test]
fn elements_come_with_their_comments() {
    let lines = "x = [\n  # the first\n  1, # one\n  2 # two\n]\n";
    let reorder = |text: &str, at: &str, to| after(text, &Edit::Move { path: path(at), to });
    assert_eq!(reorder(lines, "x[0]", 1), "x = [\n  2, # two\n  # the first\n  1, # one\n]\n");
    assert_eq!(reorder("x = [1, 2, 3]", "x[2]", 0), "x = [3, 1, 2]");
    assert_eq!(after(lines, &insert("x", 2, "3")), "x = [\n  # the first\n  1, # one\n  2, # two\n  3\n]\n");
    assert_eq!(after(lines, &insert("x", 0, "0")), "x = [\n  0,\n  # the first\n  1, # one\n  2 # two\n]\n");
    assert_eq!(after("x = []", &insert("x", 0, "0")), "x = [0]");
    let tables = "# One.\n[[a]]\nn = 1\n[[a.b]]\nm = 1\n\n# Two.\n[[a]]\nn = 2\n\n# Else.\n[c]\n";
    let swapped = "# Two.\n[[a]]\nn = 2\n\n# One.\n[[a]]\nn = 1\n[[a.b]]\nm = 1\n\n# Else.\n[c]\n";
    assert_eq!(reorder(tables, "a[1]", 0).trim_start(), swapped);
    assert_eq!(reorder(tables, "a[0]", 1).trim_start(), swapped);
}

#[test]
fn names_stay_unique() {
    let scene =
        "# Mine.\n[[object]]\nname = \"puff\" # soft\nkind = \"cloud\"\n\n[[object]]\nname = \"puff 2\"\n";
    let text = after(scene, &Edit::Duplicate { path: path("object.puff") });
    assert_eq!(
        text,
        scene.replace(
            "\n\n[[object]]",
            "\n\n# Mine.\n[[object]]\nname = \"puff 3\" # soft\nkind = \"cloud\"\n\n[[object]]"
        ),
    );
    let mut document = Document::open(scene).unwrap();
    let rename = |name: &str| Edit::Rename { path: path("object[0]"), name: name.to_owned() };
    assert_eq!(document.apply(&rename("puff 2")), Err(EditError::NameTaken("puff 2".to_owned())));
    assert_eq!(document.apply(&rename("")), Err(EditError::EmptyName));
    document.apply(&rename("a.b")).unwrap();
    assert_eq!(document.get(&path("object.\"a.b\".kind")), Some("cloud".into()));
    document.apply(&insert("object", 2, "{ name = \"a.b\", kind = \"mesh\" }")).unwrap();
    assert!(
        document.text().ends_with("\n\n[[object]]\nname = \"a.b 2\"\nkind = \"mesh\"\n"),
        "{}",
        document.text()
    );
}

#[test]
fn one_becomes_several() {
    let alone = "[camera] # Mine.\neye = [0, 0, 1]\n\n[time]\n";
    let copy = Edit::Duplicate { path: path("camera") };
    assert_eq!(
        after(alone, &copy),
        "[[camera]] # Mine.\neye = [0, 0, 1]\n\n[[camera]] # Mine.\neye = [0, 0, 1]\nname = \"main 2\"\n\n[time]\n",
    );
    assert_eq!(
        after("camera = { fov = 3 }\n", &copy),
        "camera = [{ fov = 3 }, { fov = 3, name = \"main 2\" }]\n",
    );
    let drops = "[[object]]\nname = \"p\"\ndrop = { radius = 1 }\n";
    assert_eq!(
        after(drops, &insert("object[0].drop", 1, "{ radius = 2 }")),
        "[[object]]\nname = \"p\"\ndrop = [{ radius = 1 }, { radius = 2 }]\n",
    );
    let dotted = "camera.fov = 3\n";
    let text = after(dotted, &copy);
    let read = Document::open(text.as_str()).unwrap();
    assert_eq!(
        read.get(&path("camera")),
        Some(value("[{ fov = 3 }, { fov = 3, name = \"main 2\" }]")),
        "{text}"
    );
}

#[test]
fn a_snippet_keeps_its_comments_where_it_can() {
    let snippet = "# Blows.\n[[object.force]]\nkind = \"wind\" # air\n";
    let edit =
        |list: &str| Edit::Insert { list: path(list), index: 0, item: Item::Snippet(snippet.to_owned()) };
    let scene = "[[object]]\nname = \"a\"\n";
    assert_eq!(after(scene, &edit("object[0].force")), format!("{scene}\n{snippet}"));
    let inline = "[[object]]\nname = \"a\"\nforce = [{ kind = \"drag\" }]\n";
    assert_eq!(
        after(inline, &edit("object.a.force")),
        inline.replace("[{ kind", "[{ kind = \"wind\" }, { kind"),
    );
    let mut document = Document::open(scene).unwrap();
    assert_eq!(document.apply(&edit("light")), Err(EditError::BadSnippet(path("light"))));
}

#[test]
fn a_gesture_is_one_step() {
    let mut document = Document::open("a = 1\nb = 1\n").unwrap();
    for i in 2..50 {
        document.apply_during("drag a", &set("a", &i.to_string())).unwrap();
    }
    document.apply_during("drag b", &set("b", "3")).unwrap();
    document.end_gesture();
    document.apply_during("drag b", &set("b", "4")).unwrap();
    assert_eq!(document.undo_label(), Some("Set b"));
    let mut texts = Vec::new();
    while document.undo() {
        texts.push(document.text().to_owned());
    }
    assert_eq!(texts, ["a = 49\nb = 3\n", "a = 49\nb = 1\n", "a = 1\nb = 1\n"]);
    assert!(!document.is_changed() && document.undo_label().is_none());
    while document.redo() {}
    assert_eq!(document.text(), "a = 49\nb = 4\n");
    document.mark_saved();
    assert!(!document.is_changed());
    document.undo();
    assert!(document.is_changed());
    // There and back again is no step.
    document.apply_during("drag", &set("a", "7")).unwrap();
    document.apply_during("drag", &set("a", "49")).unwrap();
    assert_eq!((document.text(), document.undo_label()), ("a = 49\nb = 3\n", Some("Set b")));
}

#[test]
fn several_edits_are_all_done_or_none() {
    let mut document = Document::open("a = 1\nb = 1\n").unwrap();
    let all = |edits| Edit::All { label: "Both".to_owned(), edits };
    document.apply(&all(vec![set("a", "2"), set("b", "2")])).unwrap();
    assert_eq!((document.text(), document.undo_label()), ("a = 2\nb = 2\n", Some("Both")));
    let broken = all(vec![set("a", "3"), set("b.c", "2")]);
    assert_eq!(document.apply(&broken), Err(EditError::NotATable(path("b"))));
    assert_eq!(document.text(), "a = 2\nb = 2\n");
}

#[test]
fn a_broken_text_is_kept_until_it_is_mended() {
    let mut document = Document::open("a = 1\nb = [\n").unwrap();
    let error = document.syntax_error().unwrap().clone();
    assert_eq!(error.line, 2, "{error}");
    assert_eq!(document.apply(&set("a", "2")), Err(EditError::Syntax(error)));
    assert_eq!(document.get(&path("a")), None);
    document.apply(&Edit::ReplaceText("a = 1\nb = []\n".to_owned())).unwrap();
    document.apply(&set("a", "2")).unwrap();
    assert_eq!(document.text(), "a = 2\nb = []\n");
    assert!(document.undo() && document.undo() && document.syntax_error().is_some());
}

#[test]
fn what_is_too_long_or_too_deep_is_refused() {
    let long = "#".repeat(fumetto_scene::limits::MAX_TEXT_BYTES + 1);
    assert!(matches!(Document::open(long.as_str()), Err(EditError::TooLong { .. })));
    let text = SceneText { name: "scene.toml", toml: &long, ..SceneText::default() };
    let report = Scene::load(&text, &mut |_| Err(String::new())).unwrap_err();
    assert_eq!(report.problems()[0].code, "too-long");
    let mut document = Document::open("a = 1\n").unwrap();
    let edit = Edit::Set { path: path("a"), value: Value::String(long.clone()) };
    assert!(matches!(document.apply(&edit), Err(EditError::TooLong { .. })));
    assert!(matches!(document.apply(&Edit::ReplaceText(long)), Err(EditError::TooLong { .. })));
    for deep in ["[", "{ a = ", "a."] {
        let text = format!("a = 1\nb = {}", deep.repeat(200_000));
        assert!(Document::open(text).unwrap().syntax_error().is_some());
    }
    let text = format!("{}a = 1", "a.".repeat(200_000));
    assert!(Document::open(text).unwrap().syntax_error().is_some());
    let nested = (0..500).fold(Value::Integer(1), |inner, _| Value::Array(vec![inner]));
    assert!(matches!(
        document.apply(&Edit::Set { path: path("a"), value: nested }),
        Err(EditError::Unwritable(_))
    ));
    assert_eq!(document.text(), "a = 1\n");
}

#[test]
fn paths_are_read_as_they_are_written() {
    for text in ["", "camera.eye[0]", "object[3].emitter[0].rate", "object.\"a.b\\\"[c]\".opacity", "a[1][2]"]
    {
        assert_eq!(path(text).to_string(), text);
    }
    let odd = Path::root().key("a=b").key("").key("puff 2").index(3);
    assert_eq!(path(&odd.to_string()), odd);
    assert_eq!(odd.steps().last(), Some(&Step::Index(3)));
    for bad in [".", "a.", "a..b", "[0]", "a[", "a[x]", "a[-1]", "a[0]b", "\"a", "a[99999999999999999999]"] {
        assert!(bad.parse::<Path>().is_err(), "{bad}");
    }
}

#[test]
fn places_and_paths_tell_each_other() {
    let scene = "seed = 7\n[camera]\neye = [0, 1.5, 6]\n[[object]]\nname = \"a\"\nink = { width = { px = 2.0 } }\n[[object]]\nname = \"b\"\nsub.key = 1\n";
    let document = Document::open(scene).unwrap();
    for at in ["seed", "camera.eye[1]", "object[0].ink.width.px", "object[1].name", "object[1].sub.key"] {
        let span = document.span(&path(at)).unwrap();
        assert_eq!(document.path_at(span.start), Some(path(at)));
    }
    assert_eq!(&scene[document.span(&path("object.b")).unwrap()], "[[object]]");
    let at = |what: &str| document.path_at(scene.find(what).unwrap()).unwrap().to_string();
    assert_eq!([at("eye"), at("width"), at("[camera]")], ["camera.eye", "object[0].ink.width", "camera"]);
    assert_eq!(document.span(&path("nothing")), None);
    assert_eq!(document.path_at(99999), None);
}
