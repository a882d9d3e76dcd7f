//! Opening a scene file with what the command line changes in it.

use std::io;
use std::path::Path;

use anyhow::Context as _;
use fumetto_scene::{Report, Scene, SceneText, StyleChoice, presets};

use crate::args::SceneArgs;
use crate::console;
use crate::exit::Stop;
use fumetto_disk::{SceneFolder, read_standard_input, read_text};

/// In place of a scene file's name: the scene comes in by a pipe, and its files lie where the program runs.
const STANDARD_INPUT: &str = "-";

/// A checked scene, and what was found on the way.
pub(crate) struct Opened {
    pub(crate) scene: Scene,
    /// Warnings only.
    pub(crate) report: Report,
    pub(crate) folder: SceneFolder,
}

/// Opens a scene and shows its warnings.
///
/// Everything that is wrong with a scene is one [`Report`] in the error.
pub(crate) fn open(args: &SceneArgs) -> anyhow::Result<Opened> {
    let opened = load(args)?;
    if !opened.report.is_empty() {
        console::say(&opened.report.render(console::stderr_is_coloured()));
    }
    Ok(opened)
}

/// Opens a scene.
pub(crate) fn load(args: &SceneArgs) -> anyhow::Result<Opened> {
    let by_pipe = args.scene == Path::new(STANDARD_INPUT);
    let name = if by_pipe { "standard input".to_owned() } else { args.scene.display().to_string() };
    let toml = if by_pipe { read_standard_input() } else { read_text(&args.scene) };
    let toml = toml.with_context(|| format!("cannot read the scene {name}"))?;
    let style = args.style.as_deref().map(Style::named).transpose()?;
    let set: Vec<(String, String)> =
        args.set.iter().map(|setting| (setting.path.clone(), setting.value.clone())).collect();
    let folder = SceneFolder::of(&args.scene);
    let text = SceneText { name: &name, toml: &toml, set: &set, style: style.as_ref().map(Style::choice) };
    let mut resolve = |path: &str| folder.read_text(path).map_err(|error| error.to_string());
    let (scene, report) = Scene::load(&text, &mut resolve)?;
    Ok(Opened { scene, report, folder })
}

/// What `--style` names.
enum Style {
    Preset(String),
    File { name: String, toml: String },
}

impl Style {
    fn named(name: &str) -> anyhow::Result<Self> {
        if presets::names().contains(&name) {
            return Ok(Self::Preset(name.to_owned()));
        }
        match read_text(Path::new(name)) {
            // Whatever the style file names lies beside it, and not beside the scene.
            Ok(toml) => {
                let place = std::path::absolute(name).with_context(|| format!("cannot find {name}"))?;
                Ok(Self::File { name: place.display().to_string(), toml })
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                let presets = presets::names().join(", ");
                Err(Stop::Usage(format!(
                    "--style {name}: there is no such file, and the presets are {presets}"
                ))
                .into())
            }
            Err(error) => Err(error).with_context(|| format!("cannot read the style file {name}")),
        }
    }

    fn choice(&self) -> StyleChoice<'_> {
        match self {
            Self::Preset(name) => StyleChoice::Preset(name),
            Self::File { name, toml } => StyleChoice::Text { name, toml },
        }
    }
}
