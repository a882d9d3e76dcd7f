//! Styles over styles: what counts where a style does not say.

use crate::edit::{Document, Path, Step, Value};
use crate::presets;

/// What a key of a style is where the style itself does not say: as in its preset, or for an object as in the scene's
/// style.
pub(super) fn inherited(document: &Document, path: &Path) -> Option<Value> {
    let is_style = |step: &Step| matches!(step, Step::Key(key) if key == "style");
    let at = path.steps().iter().position(is_style).filter(|at| *at == 0 || *at == 2)?;
    let (style, keys) = path.steps().split_at(at + 1);
    if keys.is_empty() {
        return None;
    }
    let style = Path::from(style.to_vec());
    match preset_of(document, &style) {
        Some(preset) => in_preset(&preset, keys),
        None if at == 0 => in_preset(presets::DEFAULT, keys),
        None => {
            let scene = Path::root().key("style");
            let own = keys.iter().fold(scene.clone(), |path, step| path.with(step.clone()));
            let preset = preset_of(document, &scene).unwrap_or_else(|| presets::DEFAULT.to_owned());
            document.get(&own).or_else(|| in_preset(&preset, keys))
        }
    }
}

/// The preset that a style starts from. What a style file says is not known here.
fn preset_of(document: &Document, style: &Path) -> Option<String> {
    match document.get(&style.key("preset")) {
        Some(Value::String(preset)) => Some(preset),
        _ => None,
    }
}

fn in_preset(preset: &str, keys: &[Step]) -> Option<Value> {
    let table = Value::Table(presets::text(preset)?.parse().ok()?);
    let mut value = &table;
    for step in keys {
        value = match step {
            Step::Key(key) => value.get(key.as_str())?,
            Step::Index(index) => value.get(*index)?,
        };
    }
    Some(value.clone())
}
