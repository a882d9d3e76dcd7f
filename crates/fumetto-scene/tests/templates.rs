//! What can be added to a scene is right as it is added.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod common;

use fumetto_scene::edit::templates::{ALL, Template, for_object, for_scene};
use fumetto_scene::edit::{Document, Path};

const SCENE: &str = "format = 1

[camera]
eye = [0, 1, 5]
target = [0, 0, 0]

[[light]]
kind = \"sun\"
direction = [0, -1, 0]
";

fn problems(document: &Document) -> String {
    match common::load(document.text()) {
        Ok((_, report)) | Err(report) => report.render(false),
    }
}

fn add(document: &mut Document, template: &Template, object: &Path) {
    let before = document.text().to_owned();
    document.apply(&template.add(document, object)).unwrap();
    assert_eq!(problems(document), "", "{}:\n{}", template.name, document.text());
    // In line there is no room for comments.
    let is_inline = !document.text().contains(&format!("[[{}]]", template.list));
    let comments = |text: &str| text.matches(template.docs()).count();
    assert!(is_inline || comments(document.text()) > comments(&before), "{}", document.text());
    assert!(document.undo());
    assert_eq!(document.text(), before);
    assert!(document.redo());
}

#[test]
fn everything_can_be_added() {
    let mut seen = 0;
    for template in for_scene() {
        let mut document = Document::open(SCENE).unwrap();
        if template.list != "object" {
            // A scene without objects is empty, and says so.
            let cloud = ALL.iter().find(|template| template.name == "Cloud").unwrap();
            document.apply(&cloud.add(&document, &Path::root())).unwrap();
        }
        add(&mut document, template, &Path::root());
        seen += 1;
        let object = Path::root().key("object").index(0);
        let Some(kind) = document.get(&object.key("kind")) else { continue };
        for part in for_object(kind.as_str().unwrap()).filter(|_| template.list == "object") {
            let mut document = document.clone();
            add(&mut document, part, &object);
            add(&mut document, part, &object);
            seen += 1;
        }
    }
    assert!(seen >= ALL.len(), "{seen}");
}

#[test]
fn everything_can_be_added_to_an_empty_text() {
    let mut document = Document::open("").unwrap();
    for template in for_scene() {
        document.apply(&template.add(&document, &Path::root())).unwrap();
    }
    let kinds = document.count(&Path::root().key("object"));
    assert_eq!((kinds, document.count(&Path::root().key("light"))), (6, 2));
}
