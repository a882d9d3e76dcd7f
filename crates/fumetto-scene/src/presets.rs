//! Ready-made styles.

/// The preset that is used where a scene names none.
pub(crate) const DEFAULT: &str = "cartoon";

/// Every preset: its name and its style file.
const PRESETS: [(&str, &str); 10] = [
    ("cartoon", include_str!("../presets/cartoon.style.toml")),
    ("mcguire", include_str!("../presets/mcguire.style.toml")),
    ("flat", include_str!("../presets/flat.style.toml")),
    ("no-ink", include_str!("../presets/no-ink.style.toml")),
    ("engraving", include_str!("../presets/engraving.style.toml")),
    ("crosshatch", include_str!("../presets/crosshatch.style.toml")),
    ("pencil", include_str!("../presets/pencil.style.toml")),
    ("sketch", include_str!("../presets/sketch.style.toml")),
    ("brush", include_str!("../presets/brush.style.toml")),
    ("charcoal", include_str!("../presets/charcoal.style.toml")),
];

/// The names of the presets; the first is the default.
#[must_use]
pub fn names() -> Vec<&'static str> {
    PRESETS.iter().map(|(name, _)| *name).collect()
}

/// The style file of a preset.
#[must_use]
pub fn text(name: &str) -> Option<&'static str> {
    PRESETS.iter().find(|(preset, _)| *preset == name).map(|(_, text)| *text)
}
