//! `fumetto new`

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::Context as _;
use fumetto_disk::Draft;
use fumetto_scene::starts;

use crate::args::{NewArgs, Template};
use crate::console;

pub(crate) fn run(args: &NewArgs) -> anyhow::Result<ExitCode> {
    let path = with_toml(&args.name);
    let shown = path.display();
    let mut draft = Draft::new(&path)?;
    draft.write_all(text(args.template).as_bytes()).with_context(|| format!("cannot write {shown}"))?;
    draft.publish_new()?;
    console::say(&format!(
        "wrote {shown}; draw it with: fumetto render {shown} -o {}",
        path.with_extension("gif").display()
    ));
    Ok(ExitCode::SUCCESS)
}

fn text(template: Template) -> &'static str {
    match template {
        Template::Smoke => starts::SMOKE,
        Template::Cloud => starts::CLOUD,
        Template::Explosion => starts::EXPLOSION,
    }
}

/// `name`, ending in `.toml`; dots within it are kept.
fn with_toml(name: &Path) -> PathBuf {
    if name.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
        return name.to_owned();
    }
    let mut name = name.as_os_str().to_owned();
    name.push(".toml");
    name.into()
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum as _;
    use fumetto_scene::{Scene, SceneText};

    use super::*;

    #[test]
    fn every_template_is_a_scene_without_problems() {
        for template in Template::value_variants() {
            let text = SceneText { name: "template", toml: text(*template), ..SceneText::default() };
            match Scene::load(&text, &mut |_| Err("a template stands alone".to_owned())) {
                Ok((_, report)) => assert!(report.is_empty(), "{template:?}:\n{report}"),
                Err(report) => panic!("{template:?}:\n{report}"),
            }
        }
    }

    #[test]
    fn names_end_in_toml_once() {
        assert_eq!(with_toml(Path::new("a")), Path::new("a.toml"));
        assert_eq!(with_toml(Path::new("b/a.toml")), Path::new("b/a.toml"));
        assert_eq!(with_toml(Path::new("take1.2")), Path::new("take1.2.toml"));
    }
}
