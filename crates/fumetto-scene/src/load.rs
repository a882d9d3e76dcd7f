//! From a text to a checked scene.

use crate::Scene;
use crate::check::{self, At, Styles};
use crate::file::SceneFile;
use crate::fit;
use crate::report::{Log, Report, Severity};
use crate::text::{self, Entry, Node, Place, Table, Value, parse_document};

/// The newest version of the scene format that this crate reads.
pub const FORMAT: u32 = 1;

/// Reads the text of a style file that a scene names, or says why it cannot.
pub type Resolve<'a> = dyn FnMut(&str) -> Result<String, String> + 'a;

/// A scene's text and what the command line changes in it.
#[derive(Clone, Copy, Debug, Default)]
pub struct SceneText<'a> {
    /// What the text is called in messages: its path.
    pub name: &'a str,
    /// The text.
    pub toml: &'a str,
    /// Paths and values as in `--set camera.eye[0]=2`: the value is TOML, and where it is not, a
    /// string. Elements of arrays go by number or by their `name`, as in `object.smoke.opacity`.
    pub set: &'a [(String, String)],
    /// Takes the place of the scene's `[style]`. Styles of single objects still change it.
    pub style: Option<StyleChoice<'a>>,
}

/// A style that is named beside the scene.
#[derive(Clone, Copy, Debug)]
pub enum StyleChoice<'a> {
    /// One of [`presets::names`](crate::presets::names).
    Preset(&'a str),
    /// A style file that was read already.
    Text {
        /// Its path; a `ramp` in it is looked for beside it.
        name: &'a str,
        /// Its text.
        toml: &'a str,
    },
}

impl Scene {
    /// Reads and checks a scene.
    ///
    /// The report of a good scene holds warnings only. `resolve` may be asked for the same style file
    /// several times.
    ///
    /// # Errors
    /// Everything that is wrong, errors and warnings, where there is at least one error.
    pub fn load(text: &SceneText<'_>, resolve: &mut Resolve<'_>) -> Result<(Self, Report), Report> {
        let log = Log::default();
        let scene = read(&log, text, resolve);
        let has_errors = log.has_errors();
        let report = log.finish();
        match scene {
            Some(scene) if !has_errors => Ok((scene, report)),
            _ => Err(report),
        }
    }
}

fn read(log: &Log, text: &SceneText<'_>, resolve: &mut Resolve<'_>) -> Option<Scene> {
    let mut root = parse_document(log, text.name, text.toml)?;
    check_format(log, text.name, &mut root)?;
    if let Some(choice) = text.style {
        put_style(log, &mut root, choice);
    }
    text::set(log, &mut root, text.set);
    let file: SceneFile = fit::read(log, text.name, &mut root)?;
    let mut styles = Styles { log, resolve, chosen: text.style };
    Some(check::scene(&At::root(log, text.name, &root, "scene"), &file, &mut styles))
}

/// Stops at a newer format, in which all else may differ; goes on without a format.
fn check_format(log: &Log, name: &str, root: &mut Node) -> Option<()> {
    let Value::Table(table) = &mut root.value else { return None };
    let error = |code, place: &Place, message: String, help: &str| {
        log.report(Severity::Error, code, name, Some(place), message, Some(help.to_owned()));
    };
    match table.get("format") {
        None => {
            let message = "the scene does not say in which format it is written".to_owned();
            error("missing-format", &root.place, message, "begin the file with the line: format = 1");
            let node = Node { place: root.place.clone(), value: Value::Integer(FORMAT.into()) };
            table.insert(Entry { key: "format".into(), key_place: root.place.clone(), node });
        }
        Some(Node { value: Value::Integer(format), place }) if *format > FORMAT.into() => {
            let message = format!("the scene is written in format {format}, and this Fumetto reads {FORMAT}");
            error("newer-format", place, message, "update Fumetto to open this scene");
            return None;
        }
        Some(_) => {}
    }
    Some(())
}

/// Makes `style` of the tree the chosen one, so that overrides of single keys still come on top.
fn put_style(log: &Log, root: &mut Node, choice: StyleChoice<'_>) {
    let Value::Table(table) = &mut root.value else { return };
    let (name, shown) = match choice {
        StyleChoice::Preset(preset) => ("--style", preset),
        StyleChoice::Text { name, toml } => (name, toml),
    };
    let text = log.add_text(name, shown);
    let mut style = Table::default();
    if let StyleChoice::Preset(preset) = choice {
        let place = Place { text, span: 0..preset.len() };
        let node = Node { place: place.clone(), value: Value::String(preset.to_owned()) };
        style.insert(Entry { key: "preset".into(), key_place: place, node });
    }
    let place = Place { text, span: 0..0 };
    let node = Node { place: place.clone(), value: Value::Table(style) };
    table.insert(Entry { key: "style".into(), key_place: place, node });
}
