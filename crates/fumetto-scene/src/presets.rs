//! Ready-made styles, for a gallery to show and for scenes to name.
//!
//! A new one is a file in `presets/`, a name in a group here, and a tile in `tools/scenes/styles.py`.

/// The preset that is used where a scene names none.
pub(crate) const DEFAULT: &str = "cartoon";

/// A ready-made style.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// What scenes call it.
    pub name: &'static str,
    /// Its style file, which begins with a comment of one line: what it is for.
    pub text: &'static str,
}

impl Preset {
    /// What it is for, in a line.
    #[must_use]
    pub fn about(&self) -> &'static str {
        self.text.lines().next().unwrap_or_default().trim_start_matches(['#', ' '])
    }
}

/// Presets of one kind, which stand together in a gallery.
#[derive(Clone, Copy, Debug)]
pub struct Group {
    /// What they have in common.
    pub title: &'static str,
    /// In the order in which they are shown.
    pub presets: &'static [Preset],
}

macro_rules! presets {
    ($($name:literal),+) => {
        &[$(Preset { name: $name, text: include_str!(concat!("../presets/", $name, ".style.toml")) }),+]
    };
}

/// Every preset.
const GROUPS: &[Group] = &[
    Group {
        title: "Cartoon",
        presets: presets!["cartoon", "mcguire", "flat", "no-ink", "cel", "anime", "comic", "ligne-claire"],
    },
    Group {
        title: "Drawn by hand",
        presets: presets!["pencil", "sketch", "crosshatch", "brush", "charcoal", "crayon", "sumi", "chalk"],
    },
    Group {
        title: "Printed",
        presets: presets![
            "engraving",
            "woodcut",
            "scratchboard",
            "ukiyo-e",
            "newspaper",
            "manga",
            "risograph",
            "poster"
        ],
    },
    Group { title: "Painted", presets: presets!["watercolour", "gouache", "pastel", "clay"] },
    Group { title: "Technical", presets: presets!["technical", "blueprint"] },
    Group { title: "Light", presets: presets!["noir", "silhouette", "sunset", "moonlight", "neon"] },
    Group { title: "Weather and smoke", presets: presets!["mist", "storm", "dust", "fire", "soot"] },
];

/// Every preset, in groups; the first of all is the default.
#[must_use]
pub fn groups() -> &'static [Group] {
    GROUPS
}

/// The names of the presets; the first is the default.
#[must_use]
pub fn names() -> Vec<&'static str> {
    all().map(|preset| preset.name).collect()
}

/// The style file of a preset.
#[must_use]
pub fn text(name: &str) -> Option<&'static str> {
    all().find(|preset| preset.name == name).map(|preset| preset.text)
}

fn all() -> impl Iterator<Item = &'static Preset> {
    GROUPS.iter().flat_map(|group| group.presets)
}
