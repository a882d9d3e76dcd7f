use super::At;
use super::hatching::hatching;
use super::ink::ink;
use super::ramp::{beside, exaggerate, highlight, ramp, rim};
use super::stroke;
use crate::file::{ShadingFile, ShadowFile, StyleFile};
use crate::fit;
use crate::load::{Resolve, StyleChoice};
use crate::presets;
use crate::report::Log;
use crate::text::parse_document;
use crate::{Shading, Shadow, Style};

/// Lays styles over each other: built-in values, then a preset or a style file, then changes.
pub(crate) struct Styles<'a> {
    pub(crate) log: &'a Log,
    /// Reads the text of a style file.
    pub(crate) resolve: &'a mut Resolve<'a>,
    /// The style text that takes the place of the scene's.
    pub(crate) chosen: Option<StyleChoice<'a>>,
}

impl Styles<'_> {
    /// The style of the whole scene.
    pub(crate) fn scene_style(&mut self, at: &At<'_>, file: &StyleFile) -> Style {
        let base = match self.chosen {
            Some(StyleChoice::Text { name, toml }) => self.style_text(name, toml),
            _ => self.preset(presets::DEFAULT).unwrap_or_default(),
        };
        self.changed(at, file, &base)
    }

    /// `base`, or the preset or file that `changes` names, with `changes`.
    pub(crate) fn changed(&mut self, at: &At<'_>, changes: &StyleFile, base: &Style) -> Style {
        let mut style = base.clone();
        if let Some(preset) = &changes.preset {
            match self.preset(preset) {
                Some(preset) => style = preset,
                None => unknown_preset(&at.key("preset"), preset),
            }
        }
        if let Some(path) = &changes.file {
            let at = at.key("file");
            if changes.preset.is_some() {
                let message = "`preset` and `file` both say what to start from".to_owned();
                at.error("conflicting-keys", message, "leave one of them out");
            }
            match (self.resolve)(path) {
                Ok(toml) => style = self.style_text(path, &toml),
                Err(reason) => {
                    let message = format!("the style file {path:?} cannot be read: {reason}");
                    at.error("style-file", message, "its path is relative to the scene file");
                }
            }
        }
        apply(at, changes, &mut style);
        style
    }

    /// The style of a whole file called `name`.
    fn style_text(&mut self, name: &str, toml: &str) -> Style {
        let base = self.preset(presets::DEFAULT).unwrap_or_default();
        self.layer(name, toml, &base)
    }

    fn preset(&mut self, name: &str) -> Option<Style> {
        let toml = presets::text(name)?;
        Some(self.layer(&format!("{name}.style.toml"), toml, &Style::default()))
    }

    /// `base` with what a style file called `name` says.
    fn layer(&mut self, name: &str, toml: &str, base: &Style) -> Style {
        let log = self.log;
        let Some(mut root) = parse_document(log, name, toml) else { return base.clone() };
        let Some(mut file) = fit::read::<StyleFile>(log, name, &mut root) else { return base.clone() };
        let at = At::root(log, name, &root, "style");
        if file.file.take().is_some() {
            let message = "a style file cannot start from another style file".to_owned();
            at.key("file").error(
                "nested-style",
                message,
                "start from a `preset`, or copy the other file's keys",
            );
        }
        file.ramp = file.ramp.map(|ramp| beside(name, ramp));
        stroke::beside(name, &mut file);
        self.changed(&at, &file, base)
    }
}

fn unknown_preset(at: &At<'_>, name: &str) {
    let help = fit::did_you_mean(name, &presets::names());
    at.error("unknown-preset", format!("there is no style preset {name:?}"), help);
}

/// Puts the keys that `file` has into `style`.
fn apply(at: &At<'_>, file: &StyleFile, style: &mut Style) {
    ramp(at, file, &mut style.ramp);
    if let Some(file) = &file.highlight {
        highlight(&at.key("highlight"), file, &mut style.highlight);
    }
    if let Some(file) = &file.rim {
        rim(&at.key("rim"), file, &mut style.rim);
    }
    if let Some(file) = &file.exaggerate {
        exaggerate(*file, &mut style.exaggerate);
    }
    if let Some(file) = &file.hatching {
        hatching(&at.key("hatching"), file, &mut style.hatching);
    }
    put(&mut style.form, file.form);
    put(&mut style.form_scale, file.form_scale);
    put(&mut style.wrap, file.wrap);
    put(&mut style.clean_px, file.clean.map(|clean| clean.px));
    put(&mut style.material, file.material);
    put(&mut style.material_steps, file.material_steps);
    put(&mut style.mask, file.mask);
    put(&mut style.height_px, file.height);
    put(&mut style.shading, file.shading.map(Shading::from));
    if let Some(file) = &file.ink {
        ink(&at.key("ink"), file, &mut style.ink);
    }
    if let Some(file) = &file.shadow {
        shadow(file, &mut style.shadow);
    }
    if file.shading == Some(ShadingFile::PreShaded) && !style.suits_sprites() {
        let message = "puffs of this style cannot be pre-shaded".to_owned();
        let help = "they are shaded per pixel: `gooch`, `highlight`, `rim`, `exaggerate`, `hatching` and the rows \
                    of a `ramp` need to know from where each pixel is seen";
        at.key("shading").warning("not-pre-shaded", message, help);
    }
}

pub(super) fn put<T>(slot: &mut T, value: Option<T>) {
    if let Some(value) = value {
        *slot = value;
    }
}

fn shadow(file: &ShadowFile, shadow: &mut Shadow) {
    put(&mut shadow.on, file.on);
    put(&mut shadow.receive, file.receive);
    put(&mut shadow.reach, file.reach);
    put(&mut shadow.start, file.start);
    put(&mut shadow.size, file.size);
}

impl From<ShadingFile> for Shading {
    fn from(file: ShadingFile) -> Self {
        match file {
            ShadingFile::Auto => Self::Auto,
            ShadingFile::PerPixel => Self::PerPixel,
            ShadingFile::PreShaded => Self::PreShaded,
        }
    }
}
