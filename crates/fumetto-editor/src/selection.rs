//! What is selected, and what can be done with it as a whole.

use fumetto_scene::edit::{Document, Edit, Path, Step};

/// The nearest there is: the selected thing itself, or what it lay in before it went.
pub(crate) fn nearest(document: &Document, selected: &Path) -> Path {
    let mut path = selected.clone();
    while let Some((parent, step)) = path.split_last() {
        let is_there = match step {
            Step::Index(index) => *index < document.count(&parent),
            // A table may be shown before it is written.
            Step::Key(_) => matches!(parent.steps().last(), None | Some(Step::Index(_))),
        };
        if is_there && (parent == Path::root() || nearest(document, &parent) == parent) {
            return path;
        }
        // A list by itself is nothing to show.
        let is_element = matches!(step, Step::Index(_));
        path = if is_element {
            parent.split_last().map(|(holder, _)| holder).unwrap_or_default()
        } else {
            parent
        };
    }
    path
}

/// The element of a list that is selected, or that what is selected lies in.
pub(crate) fn element(selected: &Path) -> Option<(Path, usize)> {
    let last = selected.steps().iter().rposition(|step| matches!(step, Step::Index(_)))?;
    match selected.steps()[last] {
        Step::Index(index) => Some((Path::from(selected.steps()[..last].to_vec()), index)),
        Step::Key(_) => None,
    }
}

/// The element of a list that is selected itself, and not only something in it.
pub(crate) fn whole(selected: &Path) -> Option<(Path, usize)> {
    match selected.split_last()? {
        (list, Step::Index(index)) => Some((list, *index)),
        (_, Step::Key(_)) => None,
    }
}

/// The object that is selected, or that what is selected lies in.
pub(crate) fn object(selected: &Path) -> Option<Path> {
    match selected.steps() {
        [Step::Key(list), at @ Step::Index(_), ..] if list == "object" => {
            Some(Path::root().key("object").with(at.clone()))
        }
        _ => None,
    }
}

/// What is to be selected so that the value at `path` is seen: a style, an element, or the scene.
pub(crate) fn holder(path: &Path) -> Path {
    let is_style = |step: &Step| matches!(step, Step::Key(key) if key == "style");
    match path.steps().iter().position(is_style) {
        Some(at) if at == 0 || at == 2 => Path::from(path.steps()[..=at].to_vec()),
        _ => element(path).map_or_else(Path::root, |(list, index)| list.index(index)),
    }
}

/// A copy behind the selected element, and what is selected then.
pub(crate) fn duplicate(selected: &Path) -> Option<(Edit, Path)> {
    let (list, index) = whole(selected)?;
    Some((Edit::Duplicate { path: list.index(index) }, list.index(index + 1)))
}

/// The scene without the selected element, and what is selected then: its neighbour, or what it lay in.
pub(crate) fn delete(document: &Document, selected: &Path) -> Option<(Edit, Path)> {
    let (list, index) = whole(selected)?;
    let left = document.count(&list).saturating_sub(1);
    let parent = || list.split_last().map(|(parent, _)| parent).unwrap_or_default();
    let next = if left == 0 { parent() } else { list.index(index.min(left - 1)) };
    Some((Edit::Remove { path: list.index(index) }, next))
}

/// The selected element one place up or down, and what is selected then.
pub(crate) fn shift(document: &Document, selected: &Path, down: bool) -> Option<(Edit, Path)> {
    let (list, index) = whole(selected)?;
    let to = if down { index + 1 } else { index.checked_sub(1)? };
    (to < document.count(&list)).then(|| (Edit::Move { path: list.index(index), to }, list.index(to)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCENE: &str = "camera = { eye = [0, 0, 5] }\n[[object]]\nname = \"a\"\nforce = [{}, {}]\n[[object]]\nname = \"b\"\n";

    fn document() -> Document {
        Document::open(SCENE).expect("it is short")
    }

    fn path(text: &str) -> Path {
        text.parse().expect("it is a path")
    }

    #[test]
    fn what_is_gone_is_selected_no_longer() {
        for (selected, found) in [
            ("object[1]", "object[1]"),
            ("object[2]", ""),
            ("object[0].force[5]", "object[0]"),
            ("object[7].force[0]", ""),
            ("object[0].style", "object[0].style"),
            ("camera[0]", "camera[0]"),
            ("style", "style"),
        ] {
            assert_eq!(nearest(&document(), &path(selected)), path(found), "{selected}");
        }
    }

    #[test]
    fn the_neighbour_is_selected_after_a_deletion() {
        let next = |selected: &str| delete(&document(), &path(selected)).map(|(_, next)| next.to_string());
        assert_eq!(next("object[0]").as_deref(), Some("object[0]"));
        assert_eq!(next("object[1]").as_deref(), Some("object[0]"));
        assert_eq!(next("object[0].force[1]").as_deref(), Some("object[0].force[0]"));
        assert_eq!(next("camera[0]").as_deref(), Some(""));
        for part in ["style", "object[0].style", "object[0].force", "object[0].force[1].rate"] {
            assert_eq!(next(part), None, "{part} is no element");
            assert_eq!(duplicate(&path(part)), None);
            assert_eq!(shift(&document(), &path(part), true), None);
        }
    }

    #[test]
    fn a_value_is_seen_in_what_holds_it() {
        for (value, seen) in [
            ("object[0].force[1].rate", "object[0].force[1]"),
            ("object[0].style.ink.width", "object[0].style"),
            ("style.tones[2]", "style"),
            ("time.fps", ""),
        ] {
            assert_eq!(holder(&path(value)), path(seen), "{value}");
        }
    }

    #[test]
    fn elements_stay_in_their_list() {
        let document = document();
        assert!(shift(&document, &path("object[0]"), false).is_none());
        assert!(shift(&document, &path("object[1]"), true).is_none());
        let (edit, next) = shift(&document, &path("object[0].force[0]"), true).expect("there are two");
        assert_eq!(
            (edit, next),
            (Edit::Move { path: path("object[0].force[0]"), to: 1 }, path("object[0].force[1]"))
        );
    }
}
