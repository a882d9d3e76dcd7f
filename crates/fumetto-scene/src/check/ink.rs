use super::At;
use super::stroke::stroke;
use super::style::put;
use super::values::colour;
use crate::file::{CreaseFile, HiddenLinesFile, InkFile, InkMethodFile, PenFile, WidthFile};
use crate::{HiddenLines, Ink, InkMethod, Pen, Stroke, Width};

/// Puts the keys that `file` has into `ink`.
pub(super) fn ink(at: &At<'_>, file: &InkFile, ink: &mut Ink) {
    put(&mut ink.on, file.on);
    put(&mut ink.method, file.method.map(InkMethod::from));
    put(&mut ink.colour, file.colour.as_ref().map(|file| colour(&at.key("colour"), file)));
    put(&mut ink.width, file.width.map(Width::from));
    put(&mut ink.offset, file.offset);
    put(&mut ink.inner, file.inner);
    put(&mut ink.lit_thinning, file.lit_thinning);
    put(&mut ink.shortest, file.shortest);
    put(&mut ink.facing, file.facing);
    put(&mut ink.hidden, file.hidden.map(HiddenLines::from));
    if let Some(file) = &file.stroke {
        stroke(&at.key("stroke"), file, &mut ink.stroke, None);
    }
    let common = ink.stroke.clone();
    let pens = [
        ("silhouette", &file.silhouette, &mut ink.silhouette),
        ("boundary", &file.boundary, &mut ink.boundary),
        ("material", &file.material, &mut ink.material),
    ];
    for (key, file, slot) in pens {
        if let Some(file) = file {
            pen(&at.key(key), file, slot, common.as_ref());
        }
    }
    if let Some(CreaseFile { on, colour, width, dash, angle, stroke }) = file.crease.clone() {
        let file = PenFile { on, colour, width, dash, stroke };
        pen(&at.key("crease"), &file, &mut ink.crease, common.as_ref());
        put(&mut ink.crease_deg, angle);
    }
    if ink.has_strokes() && !matches!(ink.method, InkMethod::Hybrid | InkMethod::Vector) {
        let message = "strokes follow lines that are found along contours and edges".to_owned();
        let help = "leave `method` out, or choose \"vector\"; or write stroke = { on = false }";
        at.error("strokes-without-lines", message, help);
    }
}

/// `common` is the stroke of all kinds of edges.
fn pen(at: &At<'_>, file: &PenFile, pen: &mut Pen, common: Option<&Stroke>) {
    put(&mut pen.on, file.on);
    put(&mut pen.colour, file.colour.as_ref().map(|file| Some(colour(&at.key("colour"), file))));
    put(&mut pen.width, file.width.map(|width| Some(width.into())));
    put(&mut pen.dash_px, file.dash.map(Some));
    if let Some(file) = &file.stroke {
        stroke(&at.key("stroke"), file, &mut pen.stroke, common);
    }
}

impl From<InkMethodFile> for InkMethod {
    fn from(file: InkMethodFile) -> Self {
        match file {
            InkMethodFile::Angle => Self::Angle,
            InkMethodFile::Shell => Self::Shell,
            InkMethodFile::Image => Self::Image,
            InkMethodFile::Vector => Self::Vector,
            InkMethodFile::Hybrid => Self::Hybrid,
        }
    }
}

impl From<HiddenLinesFile> for HiddenLines {
    fn from(file: HiddenLinesFile) -> Self {
        match file {
            HiddenLinesFile::Gone => Self::Gone,
            HiddenLinesFile::Dashed => Self::Dashed,
        }
    }
}

impl From<WidthFile> for Width {
    fn from(file: WidthFile) -> Self {
        match file {
            WidthFile::Px(px) => Self::Px(px),
            WidthFile::World(world) => Self::World(world),
        }
    }
}
