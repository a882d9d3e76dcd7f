use super::At;
use super::ramp::beside_path;
use super::style::put;
use crate::file::{InkFile, StrokeFile, StyleFile};
use crate::fit;
use crate::{Stroke, StrokeTexture};

/// Puts the keys that `file` has into `slot`; where there is nothing yet, into what `common` says.
pub(super) fn stroke(at: &At<'_>, file: &StrokeFile, slot: &mut Option<Stroke>, common: Option<&Stroke>) {
    let base = slot.take().or_else(|| common.cloned());
    let mut stroke = match &file.texture {
        Some(name) => Stroke::of(texture(&at.key("texture"), name)),
        None => base.unwrap_or_else(|| Stroke::of(StrokeTexture::Pencil)),
    };
    put(&mut stroke.on, file.on);
    put(&mut stroke.height, file.height.map(|height| Some(height.into())));
    put(&mut stroke.scale, file.scale);
    put(&mut stroke.outward, file.outward);
    put(&mut stroke.taper, file.taper);
    put(&mut stroke.pressure, file.pressure);
    put(&mut stroke.curvature, file.curvature);
    put(&mut stroke.distance, file.distance);
    put(&mut stroke.wobble, file.wobble);
    put(&mut stroke.overshoot, file.overshoot);
    put(&mut stroke.passes, file.passes);
    put(&mut stroke.grain, file.grain);
    put(&mut stroke.boil, file.boil);
    *slot = Some(stroke);
}

fn texture(at: &At<'_>, name: &str) -> StrokeTexture {
    if is_file(name) {
        return StrokeTexture::File(name.to_owned());
    }
    let named = StrokeTexture::NAMED.into_iter().find(|(known, _)| *known == name);
    named.map_or_else(
        || {
            let names = StrokeTexture::NAMED.map(|(known, _)| known);
            let help = format!("{} (a picture ends in .png)", fit::did_you_mean(name, &names));
            at.error("unknown-texture", format!("there is no texture {name:?}"), help);
            StrokeTexture::Pencil
        },
        |(_, texture)| texture,
    )
}

fn is_file(name: &str) -> bool {
    name.rsplit_once('.').is_some_and(|(_, end)| end.eq_ignore_ascii_case("png"))
}

/// Takes the paths of textures in the style file `name` to be relative to where that is.
pub(super) fn beside(name: &str, style: &mut StyleFile) {
    let Some(InkFile { stroke, silhouette, crease, boundary, material, .. }) = &mut style.ink else { return };
    let pens = [silhouette, boundary, material].into_iter().flatten().map(|pen| &mut pen.stroke);
    let crease = crease.iter_mut().map(|crease| &mut crease.stroke);
    for stroke in pens.chain(crease).chain([stroke]).flatten() {
        if let Some(path) = stroke.texture.take() {
            stroke.texture = Some(if is_file(&path) { beside_path(name, path) } else { path });
        }
    }
}
