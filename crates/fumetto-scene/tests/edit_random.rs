//! Whatever is done to whatever text: values come out as they were set, and undoing it all gives the start.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::sync::LazyLock;

use fumetto_scene::edit::{Document, Edit, Item, Path, Step, Value};
use proptest::prelude::*;

/// Texts in which the same is written in many ways, and every scene that there is.
static TEXTS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut paths: Vec<_> = paths.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    paths.sort();
    let mut texts: Vec<String> = paths.iter().map(|path| std::fs::read_to_string(path).unwrap()).collect();
    assert!(texts.len() > 20, "the folder of scenes is there");
    texts.extend(
        [ODD, &ODD.replace('\n', "\r\n"), &format!("\u{feff}{ODD}"), include_str!("good/everything.toml")]
            .map(str::to_owned),
    );
    texts
});

const ODD: &str = "# Odd, but TOML.
format = 1 # one
camera.eye = [ 0 , 1.5,6 ] # dotted
camera . \"field of view\" = 40

x = { a.b = 1, a.c = '''two''', d = [ { e = 1 }, { e = 2 }, ] } # inline
# Rows.
rows = [
  # above one
  [1, 2], # behind one

  # above two
  { n = \"\"\"
# no comment
\"\"\" }, # behind two
  3 # behind three
] # behind all
flow = [1, 2,
  3, 4] # behind flow
[a.b.c]
k = 1
[[list]] # first
name = \"one\"
sub.dotted = 1
[list.table]
[[list.inner]]
n = 1
  [[list.inner]]
  n = 2
# About the second.

# Right above the second.
[[list]]
name = \"two\"
[other]
# Nothing in here.
[list.table] # of the second, far away
n = 9
[last] # the end";

/// All paths in a value.
fn paths(value: &Value, at: &Path, found: &mut Vec<Path>) {
    found.push(at.clone());
    match value {
        Value::Table(table) => {
            for (key, value) in table {
                paths(value, &at.key(key), found);
            }
        }
        // Of long lists the first elements will do.
        Value::Array(items) => {
            for (index, value) in items.iter().enumerate().take(8) {
                paths(value, &at.index(index), found);
            }
        }
        _ => {}
    }
}

fn at_mut<'v>(value: &'v mut Value, path: &[Step]) -> Option<&'v mut Value> {
    path.iter().try_fold(value, |value, step| match step {
        Step::Key(key) => value.get_mut(key.as_str()),
        Step::Index(index) => value.get_mut(*index),
    })
}

/// What `edit` should make of `value`; `None` where it should be refused or nothing is said.
fn expected(mut value: Value, edit: &Edit) -> Option<Value> {
    let split = |path: &Path| path.split_last().map(|(parent, last)| (parent, last.clone()));
    match edit {
        Edit::Set { path, value: new } => match split(path)? {
            (parent, Step::Key(key)) => {
                at_mut(&mut value, parent.steps())?.as_table_mut()?.insert(key, new.clone());
            }
            _ => *at_mut(&mut value, path.steps())? = new.clone(),
        },
        Edit::Remove { path } => match split(path)? {
            (parent, Step::Key(key)) => {
                at_mut(&mut value, parent.steps())?.as_table_mut()?.remove(&key)?;
            }
            (parent, Step::Index(index)) => {
                let items = at_mut(&mut value, parent.steps())?.as_array_mut()?;
                items.remove(index);
            }
        },
        Edit::Insert { list, index, item: Item::Value(new) } => {
            let items = at_mut(&mut value, list.steps())?.as_array_mut()?;
            (*index <= items.len()).then(|| items.insert(*index, new.clone()))?;
        }
        Edit::Move { path, to } => {
            let (parent, Step::Index(from)) = split(path)? else { return None };
            let items = at_mut(&mut value, parent.steps())?.as_array_mut()?;
            (*to < items.len()).then(|| {
                let moved = items.remove(from);
                items.insert(*to, moved);
            })?;
        }
        _ => return None,
    }
    Some(value)
}

/// Without what is empty: the last header that goes leaves no trace of what it was in.
fn trimmed(value: &Value) -> Value {
    match value {
        Value::Table(table) => {
            let entries = table.iter().map(|(key, value)| (key.clone(), trimmed(value)));
            let is_something = |value: &Value| {
                value.as_array().is_none_or(|items| !items.is_empty())
                    && value.as_table().is_none_or(|table| !table.is_empty())
            };
            let mut entries: Vec<_> = entries.filter(|(_, value)| is_something(value)).collect();
            entries.sort_by(|a, b| a.0.cmp(&b.0));
            Value::Table(entries.into_iter().collect())
        }
        Value::Array(items) => Value::Array(items.iter().map(trimmed).collect()),
        Value::Integer(number) => Value::Float(*number as f64),
        Value::Float(number) => Value::Float(f64::from(*number as f32)),
        other => other.clone(),
    }
}

fn comments(text: &str) -> Vec<&str> {
    let comment = |line: &str| line.find("# ").map(|at| at..line.len());
    text.lines().filter_map(|line| Some(line.get(comment(line)?)?.trim_end())).collect()
}

fn number() -> impl Strategy<Value = Value> {
    prop_oneof![
        any::<f32>().prop_filter("a number", |n| n.is_finite()).prop_map(|n| Value::Float(n.into())),
        (-5..100_i64).prop_map(Value::Integer),
        any::<bool>().prop_map(Value::Boolean),
    ]
}

fn leaf() -> impl Strategy<Value = Value> {
    prop_oneof![
        number(),
        "\\PC{0,6}".prop_map(Value::String),
        "#[0-9a-f]{6}".prop_map(Value::String),
        any::<String>().prop_map(Value::String),
    ]
}

fn any_value() -> impl Strategy<Value = Value> {
    leaf().prop_recursive(3, 12, 4, |inner| {
        let key = prop_oneof!["[a-e]", "\\PC{0,4}"];
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..4).prop_map(Value::Array),
            prop::collection::vec((key, inner), 0..4)
                .prop_map(|entries| Value::Table(entries.into_iter().collect())),
        ]
    })
}

/// One thing done; places are taken modulo what is there.
#[derive(Clone, Debug)]
enum Deed {
    Set(usize, Value),
    Add(usize, String, Value),
    Remove(usize),
    Insert(usize, usize, Value),
    Move(usize, usize),
    Duplicate(usize),
    Rename(usize, String),
}

fn deed() -> impl Strategy<Value = Deed> {
    let at = any::<usize>();
    let key = prop_oneof![Just("force".to_owned()), Just("style".to_owned()), "[a-e]", "\\PC{1,4}"];
    prop_oneof![
        4 => (at, any_value()).prop_map(|(at, value)| Deed::Set(at, value)),
        2 => (at, key, any_value()).prop_map(|(at, key, value)| Deed::Add(at, key, value)),
        2 => at.prop_map(Deed::Remove),
        2 => (at, 0..4_usize, any_value()).prop_map(|(at, index, value)| Deed::Insert(at, index, value)),
        2 => (at, 0..4_usize).prop_map(|(at, to)| Deed::Move(at, to)),
        1 => at.prop_map(Deed::Duplicate),
        1 => (at, "\\PC{0,4}").prop_map(|(at, name)| Deed::Rename(at, name)),
    ]
}

fn edit_of(deed: &Deed, document: &Document) -> Edit {
    let mut all = Vec::new();
    paths(&document.get(&Path::root()).unwrap(), &Path::root(), &mut all);
    let find = |at: usize, wanted: &dyn Fn(&Path) -> bool| {
        let some: Vec<&Path> = all.iter().filter(|path| wanted(path)).collect();
        some.get(at % some.len().max(1)).map_or_else(Path::root, |path| (*path).clone())
    };
    let some = |at: usize| find(at, &|path| *path != Path::root());
    let is_item = |path: &Path| matches!(path.steps().last(), Some(Step::Index(_)));
    match deed.clone() {
        Deed::Set(at, value) => Edit::Set { path: some(at), value },
        Deed::Add(at, key, value) => {
            let is_table = |path: &Path| document.get(path).is_some_and(|value| value.is_table());
            Edit::Set { path: find(at, &is_table).key(key), value }
        }
        Deed::Remove(at) => Edit::Remove { path: some(at) },
        Deed::Insert(at, index, value) => {
            let is_array = |path: &Path| document.get(path).is_some_and(|value| value.is_array());
            Edit::Insert { list: find(at, &is_array), index, item: Item::Value(value) }
        }
        Deed::Move(at, to) => Edit::Move { path: find(at, &is_item), to },
        Deed::Duplicate(at) => Edit::Duplicate { path: find(at, &is_item) },
        Deed::Rename(at, name) => Edit::Rename { path: find(at, &is_item), name },
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn edits_do_what_they_say_and_can_be_undone(
        text in any::<prop::sample::Index>(),
        deeds in prop::collection::vec(deed(), 1..8),
    ) {
        let text = text.get(&TEXTS);
        let mut document = Document::open(text.as_str()).unwrap();
        prop_assert!(document.syntax_error().is_none(), "{:?}", document.syntax_error());
        for deed in &deeds {
            let edit = edit_of(deed, &document);
            let (before, value) = (document.text().to_owned(), document.get(&Path::root()).unwrap());
            match document.apply(&edit) {
                Ok(()) => {
                    let now = document.get(&Path::root()).unwrap();
                    if let Some(wanted) = expected(value, &edit) {
                        prop_assert!(
                            trimmed(&now) == trimmed(&wanted),
                            "{edit:?}\n{before}\n=>\n{}\n{wanted:#?}", document.text()
                        );
                    }
                    let read = toml::from_str::<toml::Table>(document.text()).map(Value::Table);
                    prop_assert_eq!(format!("{:?}", read.unwrap()), format!("{now:?}"));
                }
                Err(error) => {
                    prop_assert_eq!(document.text(), &before);
                    prop_assert!(!error.to_string().contains("cannot be written"), "{edit:?}\n{before}\n{error}");
                }
            }
        }
        let end = document.text().to_owned();
        while document.undo() {}
        prop_assert_eq!(document.text(), text.as_str());
        while document.redo() {}
        prop_assert_eq!(document.text(), end);
    }

    #[test]
    fn comments_stay_when_values_are_set(
        text in any::<prop::sample::Index>(),
        sets in prop::collection::vec((any::<usize>(), number()), 1..20),
    ) {
        let text = text.get(&TEXTS);
        let mut document = Document::open(text.as_str()).unwrap();
        for (at, value) in sets {
            let mut all = Vec::new();
            paths(&document.get(&Path::root()).unwrap(), &Path::root(), &mut all);
            all.retain(|path| {
                let value = document.get(path).unwrap();
                !value.is_table() && !value.is_array() && !value.as_str().is_some_and(|text| text.contains('#'))
            });
            document.apply(&Edit::Set { path: all[at % all.len()].clone(), value }).unwrap();
        }
        prop_assert_eq!(comments(document.text()), comments(text));
    }

    #[test]
    fn any_text_is_opened(text in any::<String>(), toml in "[\\[\\]{}=.,\"'#a-c0-9\n\r ]{0,40}") {
        for text in [text, toml] {
            let mut document = Document::open(text.as_str()).unwrap();
            let is_read = toml::from_str::<toml::Table>(&text).is_ok();
            prop_assert_eq!(document.syntax_error().is_none(), is_read, "{:?} {:?}", text, document.syntax_error());
            let edit = Edit::Set { path: Path::root().key("seed"), value: Value::Integer(7) };
            if document.apply(&edit).is_ok() {
                prop_assert_eq!(document.get(&Path::root().key("seed")), Some(Value::Integer(7)));
            }
        }
    }
}
