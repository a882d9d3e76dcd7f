//! From the text of a scene of ours to the scene.

use anyhow::anyhow;
use fumetto_scene::{Scene, SceneText};

/// Reads `toml`, which names no style file; `name` is what messages call it.
pub(crate) fn load(name: &str, toml: &str) -> anyhow::Result<Scene> {
    let text = SceneText { name, toml, ..Default::default() };
    let mut no_files = |path: &str| Err(format!("there is no `{path}`"));
    match Scene::load(&text, &mut no_files) {
        Ok((scene, _)) => Ok(scene),
        Err(report) => Err(anyhow!(report.render(false))),
    }
}
