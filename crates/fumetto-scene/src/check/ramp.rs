//! What light turns into.

use super::At;
use super::style::put;
use super::tones::tones;
use super::values::colour;
use crate::file::{
    ExaggerateFile, GoochFile, HighlightFile, RampFile, RampImageFile, RampRowsFile, RimFile, StyleFile,
};
use crate::{Exaggerate, Gooch, Highlight, Ramp, RampImage, RampRows, Rim};

/// Puts the one of `tones`, `ramp` and `gooch` that `file` has into `slot`.
pub(super) fn ramp(at: &At<'_>, file: &StyleFile, slot: &mut Ramp) {
    let given =
        [("tones", file.tones.is_some()), ("ramp", file.ramp.is_some()), ("gooch", file.gooch.is_some())];
    let given: Vec<_> = given.into_iter().filter_map(|(key, is_given)| is_given.then_some(key)).collect();
    if let [first, .., last] = given[..] {
        let message = format!("`{first}` and `{last}` both say how light turns to colour");
        at.key(last).error("conflicting-keys", message, "leave one of them out");
    } else if let Some(file) = &file.tones {
        *slot = Ramp::Tones(tones(&at.key("tones"), file));
    } else if let Some(file) = &file.ramp {
        *slot = Ramp::Image(image(&at.key("ramp"), file));
    } else if let Some(file) = &file.gooch {
        let base = if let Ramp::Gooch(gooch) = slot { *gooch } else { Gooch::default() };
        *slot = Ramp::Gooch(gooch(&at.key("gooch"), file, base));
    }
}

/// `ramp`, whose path is relative to the file `name`, with a path relative to where `name` is.
pub(super) fn beside(name: &str, ramp: RampFile) -> RampFile {
    match ramp {
        RampFile::Path(path) => RampFile::Path(beside_path(name, path)),
        RampFile::Image(file) => {
            RampFile::Image(RampImageFile { image: beside_path(name, file.image), ..file })
        }
    }
}

/// A path that the file `name` gives, from where that file's own path begins.
pub(super) fn beside_path(name: &str, path: String) -> String {
    match name.rfind(['/', '\\']) {
        Some(end) if !path.starts_with(['/', '\\']) => format!("{}{path}", &name[..=end]),
        _ => path,
    }
}

fn image(at: &At<'_>, file: &RampFile) -> RampImage {
    match file {
        RampFile::Path(path) => RampImage { path: path.clone(), rows: RampRows::Middle },
        RampFile::Image(RampImageFile { image, rows }) => {
            let rows = rows.map_or(RampRows::Middle, |file| rows_of(&at.key("rows"), file));
            RampImage { path: image.clone(), rows }
        }
    }
}

fn rows_of(at: &At<'_>, file: RampRowsFile) -> RampRows {
    match file {
        RampRowsFile::Depth(depth) => RampRows::Depth(rising(&at.key("depth"), depth)),
        RampRowsFile::Facing(exponent) => RampRows::Facing(exponent),
        RampRowsFile::Focus(focus) => RampRows::Focus {
            center: focus.center,
            radius: rising(&at.key("focus").key("radius"), focus.radius),
        },
    }
}

/// Distances of the top row and the bottom row.
fn rising(at: &At<'_>, [top, bottom]: [f32; 2]) -> [f32; 2] {
    if top >= bottom {
        let message = format!("`{}` runs from {top} to {bottom}: the top row must be nearer", at.name());
        at.error("not-rising", message, "write the smaller distance first, and turn the picture upside down");
    }
    [top, bottom]
}

fn gooch(at: &At<'_>, file: &GoochFile, mut gooch: Gooch) -> Gooch {
    let picked = |key, file: &Option<_>| file.as_ref().map(|file| colour(&at.key(key), file));
    put(&mut gooch.cool, picked("cool", &file.cool));
    put(&mut gooch.warm, picked("warm", &file.warm));
    put(&mut gooch.colour, picked("colour", &file.colour));
    put(&mut gooch.alpha, file.alpha);
    put(&mut gooch.beta, file.beta);
    gooch
}

/// Puts the keys that `file` has into `highlight`, which they switch on.
pub(super) fn highlight(at: &At<'_>, file: &HighlightFile, highlight: &mut Highlight) {
    highlight.on = file.on.unwrap_or(true);
    put(&mut highlight.colour, file.colour.as_ref().map(|file| colour(&at.key("colour"), file)));
    put(&mut highlight.from, file.from);
    put(&mut highlight.gloss, file.gloss);
}

/// Puts the keys that `file` has into `rim`, which they switch on.
pub(super) fn rim(at: &At<'_>, file: &RimFile, rim: &mut Rim) {
    rim.on = file.on.unwrap_or(true);
    put(&mut rim.colour, file.colour.as_ref().map(|file| colour(&at.key("colour"), file)));
    put(&mut rim.width, file.width);
    put(&mut rim.from, file.from);
}

/// Puts the keys that `file` has into `exaggerate`, which they switch on.
pub(super) fn exaggerate(file: ExaggerateFile, exaggerate: &mut Exaggerate) {
    let amount = if exaggerate.amount == 0.0 { 1.0 } else { exaggerate.amount };
    exaggerate.amount = file.amount.unwrap_or(amount);
    put(&mut exaggerate.scales, file.scales);
    put(&mut exaggerate.contrast, file.contrast);
}
