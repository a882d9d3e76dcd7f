//! What the schema's own words say: summaries, units, defaults and ranges.

use crate::edit::Value;
use crate::limits::Limit;

/// What something is, in the words of the scene format.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Docs {
    /// The first sentence.
    pub summary: String,
    /// The other sentences.
    pub details: String,
}

impl Docs {
    pub(super) fn new(text: &str) -> Self {
        let text = text.replace('\n', " ");
        let end = text.find(". ").map_or(text.len(), |end| end + 1);
        let (summary, details) = text.split_at(end);
        Self { summary: summary.to_owned(), details: details.trim().to_owned() }
    }
}

/// Phrases that tell a unit. Where one holds another the longer comes first.
const UNITS: [(&str, &str); 25] = [
    ("cubic metres a second", "m³/s"),
    ("m²/s", "m²/s"),
    ("m/s²", "m/s²"),
    ("m/s", "m/s"),
    ("radii a second", "radii/s"),
    ("Particles a second", "1/s"),
    ("Rings a second", "1/s"),
    ("volumes a second", "1/s"),
    ("Frames in a second", "1/s"),
    ("per square second", "1/s²"),
    ("per second", "1/s"),
    ("Per second", "1/s"),
    ("per metre", "1/m"),
    ("in metres", "m"),
    ("In metres", "m"),
    ("metres of", "m"),
    ("Metres from", "m"),
    ("in degrees", "°"),
    ("in seconds", "s"),
    ("Seconds ", "s"),
    ("in pixels", "px"),
    ("In pixels", "px"),
    ("of a cell in pixels", "px"),
    ("Frames ", "frames"),
    ("degrees", "°"),
];

/// The unit that a description names first; empty where it names none.
pub(super) fn unit(text: &str) -> &'static str {
    let found = UNITS.iter().filter_map(|(phrase, unit)| Some((text.find(phrase)?, *unit)));
    found.min_by_key(|(at, _)| *at).map_or("", |(_, unit)| unit)
}

/// The default that a description states, as in "Default 3 px." or `"hybrid" (the default)`.
pub(super) fn stated_default(text: &str) -> Option<Value> {
    if let Some((before, _)) = text.split_once("\" (the default") {
        return Some(Value::String(before.rsplit('"').next()?.to_owned()));
    }
    let stated = text.rsplit_once("Default ").or_else(|| text.rsplit_once("Default: "))?.1;
    let end = stated.find(". ").unwrap_or_else(|| stated.trim_end_matches('.').len());
    let stated = stated[..end].trim_matches(['`', ' ']);
    let toml = match stated.strip_suffix(" px") {
        Some(number) => format!("v = {{ px = {number} }}"),
        None => format!("v = {stated}"),
    };
    toml.parse::<toml::Table>().ok()?.remove("v")
}

/// The range that a description states: "above 0", "0 (whole) to 1 (gone)".
pub(super) fn stated_range(text: &str) -> Option<Limit> {
    if text.contains("above 0") {
        return Some(crate::limits::LENGTH);
    }
    let is_share = text.contains("0 (whole) to 1 (gone)") || text.contains("0 (gone) to 1 (opaque)");
    is_share.then_some(crate::limits::SHARE)
}

/// A key for people: `mass_over_life` is "Mass over life".
pub(super) fn label(key: &str) -> String {
    let mut letters = key.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).map(|letter| if matches!(letter, '_' | '-') { ' ' } else { letter }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_understood() {
        let docs = Docs::new("Its radius in metres,\nabove 0. Default 2.");
        assert_eq!((&*docs.summary, &*docs.details), ("Its radius in metres, above 0.", "Default 2."));
        assert_eq!(unit("At birth, in m/s²."), "m/s²");
        assert_eq!(stated_default("Tones. Default 0.85."), Some(0.85.into()));
        assert_eq!(stated_default("Default \"#000066\"."), Some("#000066".into()));
        assert_eq!(
            stated_default("Default 6 px.").and_then(|value| value.get("px").cloned()),
            Some(6.into())
        );
        assert_eq!(stated_default("Default: half a cell."), None);
        assert_eq!(stated_default("How: \"hybrid\" (the default) takes what suits."), Some("hybrid".into()));
        assert_eq!(label("light_cells"), "Light cells");
    }
}
