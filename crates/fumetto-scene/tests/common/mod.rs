//! Loading scenes in tests.

use fumetto_scene::{Report, Scene, SceneText};

/// Loads a scene whose style files are `styles`.
pub(crate) fn load_with(text: &SceneText<'_>, styles: &[(&str, &str)]) -> Result<(Scene, Report), Report> {
    let find = |name: &str| styles.iter().find(|(style, _)| *style == name);
    Scene::load(text, &mut |name| {
        find(name).map(|(_, toml)| (*toml).to_owned()).ok_or_else(|| "no such file".to_owned())
    })
}

/// Loads a scene alone.
pub(crate) fn load(toml: &str) -> Result<(Scene, Report), Report> {
    load_with(&SceneText { name: "scene.toml", toml, ..SceneText::default() }, &[])
}
