//! Scenes that come with the editor.

use crate::files::Files;

/// A scene to begin with.
pub(crate) struct Example {
    /// Its file's name.
    pub(crate) name: &'static str,
    /// What it shows.
    pub(crate) shows: &'static str,
    pub(crate) text: &'static str,
    files: &'static [(&'static str, &'static [u8])],
}

impl Example {
    pub(crate) fn files(&self) -> Files {
        let mut files = Files::default();
        for (name, bytes) in self.files {
            files.add(*name, *bytes);
        }
        files
    }
}

macro_rules! example {
    ($name:literal, $shows:literal $(, $file:literal)*) => {
        Example {
            name: concat!($name, ".toml"),
            shows: $shows,
            text: include_str!(concat!("../../../scenes/", $name, ".toml")),
            files: &[$(($file, include_bytes!(concat!("../../../scenes/", $file)))),*],
        }
    };
}

/// All examples; the first is what a newcomer sees.
pub(crate) const EXAMPLES: &[Example] = &[
    example!("cumulus", "A towering cloud of puffs", "cumulus.csv"),
    example!("cloud-simple", "A cloud of a few weighted particles, as one smooth body"),
    example!("chimney", "Smoke that curls from a chimney, cut out and shaded in tones", "roof.png"),
    example!("explosion", "A burst that rolls outward and cools"),
    example!("rings", "Smoke rings that leapfrog through each other"),
    example!("storm", "A thunderhead with an anvil", "storm.csv"),
    example!("cloud-ink", "A cloud in nothing but ink lines"),
    example!("sketch", "A cloud in strokes of a pencil, on paper"),
    example!("strokes", "Brush, chalk and charcoal beside each other"),
    example!("puff-fuzzy", "A pyroclastic puff with a soft edge"),
    example!("dust-cloud", "Dust that billows over the ground, as a volume in flat tones"),
    example!(
        "metamorphosis",
        "A cloud that becomes a rabbit and drifts apart",
        "metamorphosis-cloud.csv",
        "metamorphosis-rabbit.csv",
        "metamorphosis-wisps.csv"
    ),
    example!("genie", "Smoke out of a lamp, with a drawing behind it", "lamp.png"),
    example!("paint-pour", "Paint that finds its way down steps", "steps.glb"),
    example!("paint-powder", "Powder that colours what it touches", "cottage.glb"),
    example!("obstacle", "Smoke that flows round what stands in its way", "balls.glb"),
];

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use fumetto_scene::{Scene, SceneText};

    use super::*;

    #[test]
    fn every_example_is_whole_and_without_fault() {
        for example in EXAMPLES {
            let files = example.files();
            let text = SceneText { name: example.name, toml: example.text, ..SceneText::default() };
            let (_, report) = Scene::load(&text, &mut |path| files.text(path)).unwrap();
            assert!(report.is_empty(), "{}: {report}", example.name);
            for (name, _) in example.files {
                assert!(example.text.contains(name), "{} does not need {name}", example.name);
            }
        }
    }
}
