//! Whatever is done to a scene's text: no panic, and every problem says where.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod common;

use fumetto_scene::{Report, Severity};
use proptest::prelude::*;

const SCENES: [&str; 3] = [
    include_str!("good/cumulus.toml"),
    include_str!("good/everything.toml"),
    include_str!("bad/several_at_once.toml"),
];

/// One thing done to a text; positions are taken modulo what is there.
#[derive(Clone, Debug)]
enum Mutation {
    FlipByte(usize, u8),
    Delete(usize, usize),
    DoubleLine(usize),
    DropLine(usize),
    SwapNumber(usize, &'static str),
    Insert(usize, &'static str),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    const NUMBERS: [&str; 11] =
        ["nan", "inf", "-1", "0", "1e30", "1e-300", "4294967296", "-0.0", "\"a\"", "[]", "{}"];
    const TEXTS: [&str; 12] =
        ["[[", "]", "{", "=", "\"", "\n", "a.b.c = 1\n", "#", "'''", "\u{feff}", "é", "[object.x]\n"];
    prop_oneof![
        (any::<usize>(), any::<u8>()).prop_map(|(at, mask)| Mutation::FlipByte(at, mask)),
        (any::<usize>(), 1..20_usize).prop_map(|(at, len)| Mutation::Delete(at, len)),
        any::<usize>().prop_map(Mutation::DoubleLine),
        any::<usize>().prop_map(Mutation::DropLine),
        (any::<usize>(), prop::sample::select(&NUMBERS[..]))
            .prop_map(|(at, to)| Mutation::SwapNumber(at, to)),
        (any::<usize>(), prop::sample::select(&TEXTS[..])).prop_map(|(at, what)| Mutation::Insert(at, what)),
    ]
}

fn mutate(text: &str, mutation: &Mutation) -> String {
    let mut bytes = text.as_bytes().to_vec();
    let mut lines: Vec<&str> = text.lines().collect();
    match *mutation {
        _ if text.is_empty() => return text.to_owned(),
        Mutation::FlipByte(at, mask) => bytes[at % text.len()] ^= mask,
        Mutation::Delete(at, len) => {
            let at = at % text.len();
            bytes.drain(at..(at + len).min(text.len()));
        }
        Mutation::DoubleLine(at) => {
            let at = at % lines.len();
            lines.insert(at, lines[at]);
            return lines.join("\n");
        }
        Mutation::DropLine(at) => {
            lines.remove(at % lines.len());
            return lines.join("\n");
        }
        Mutation::SwapNumber(at, to) => return swap_number(text, at, to),
        Mutation::Insert(at, what) => {
            let at = at % text.len();
            bytes.splice(at..at, what.bytes());
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The text with one of its numbers replaced.
fn swap_number(text: &str, at: usize, to: &str) -> String {
    let is_number = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let starts: Vec<usize> = text
        .match_indices(is_number)
        .map(|(i, _)| i)
        .filter(|&i| !text[..i].ends_with(|c: char| is_number(c) || c.is_alphanumeric()))
        .collect();
    let Some(&start) = starts.get(at % starts.len().max(1)) else { return text.to_owned() };
    let rest = text[start..].trim_start_matches(is_number);
    format!("{}{to}{rest}", &text[..start])
}

fn check(report: &Report) {
    for problem in report.problems() {
        assert!(!problem.file.is_empty());
        assert!(!problem.message.is_empty());
        // The schema walk must have seen all that serde would stumble over.
        assert_ne!(problem.code, "unreadable", "{}", problem.message);
        let text = report.text(&problem.file).unwrap();
        let span = problem.span.clone().unwrap();
        assert!(text.get(span.clone()).is_some(), "{span:?} in {} bytes: {}", text.len(), problem.message);
        assert!(report.position(problem).is_some());
    }
    assert_eq!(report.render(true).is_empty(), report.is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_mutated_scene_is_read_or_explained(
        scene in prop::sample::select(&SCENES[..]),
        mutations in prop::collection::vec(mutation(), 1..6),
    ) {
        let text = mutations.iter().fold(scene.to_owned(), |text, mutation| mutate(&text, mutation));
        match common::load(&text) {
            Ok((_, warnings)) => {
                prop_assert_eq!(warnings.count(Severity::Error), 0);
                check(&warnings);
            }
            Err(report) => {
                prop_assert!(report.count(Severity::Error) > 0);
                check(&report);
            }
        }
    }

    #[test]
    fn any_override_is_taken_or_explained(path in "[a-z.\\[\\]0-2é]{0,12}", value in "\\PC{0,12}") {
        let set = [("object.fire.opacity".to_owned(), "0.5".to_owned()), (path, value)];
        let toml = SCENES[1];
        let text = fumetto_scene::SceneText { name: "scene.toml", toml, set: &set, style: None };
        match common::load_with(&text, &[]) {
            Ok((_, report)) | Err(report) => check(&report),
        }
    }
}
