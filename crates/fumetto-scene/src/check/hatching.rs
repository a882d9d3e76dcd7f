use super::At;
use super::style::put;
use super::values::colour;
use crate::file::{AlongFile, FollowFile, HatchingFile};
use crate::{Along, Follow, Hatching, Width};

/// Puts the keys that `file` has into `hatching`, which they switch on.
pub(super) fn hatching(at: &At<'_>, file: &HatchingFile, hatching: &mut Hatching) {
    hatching.on = file.on.unwrap_or(true);
    put(&mut hatching.colour, file.colour.as_ref().map(|file| colour(&at.key("colour"), file)));
    put(&mut hatching.width, file.width.map(Width::from));
    put(&mut hatching.spacing, file.spacing.map(Width::from));
    put(&mut hatching.from, file.from);
    put(&mut hatching.full, file.full);
    put(&mut hatching.swell, file.swell);
    put(&mut hatching.levels, file.levels);
    put(&mut hatching.layers, file.layers);
    put(&mut hatching.cross_deg, file.cross);
    put(&mut hatching.along, file.along.map(Along::from));
    put(&mut hatching.angle_deg, file.angle);
    put(&mut hatching.tilt_deg, file.tilt);
    put(&mut hatching.follow, file.follow.map(Follow::from));
    put(&mut hatching.length_px, file.length.map(|length| length.px));
    put(&mut hatching.gaps, file.gaps);
    put(&mut hatching.wobble_px, file.wobble.map(|wobble| wobble.px));
    put(&mut hatching.tooth, file.tooth);
    put(&mut hatching.smooth_px, file.smooth.map(|smooth| smooth.px));
    makes_sense(at, hatching);
}

fn makes_sense(at: &At<'_>, hatching: &Hatching) {
    let Hatching { full, from, .. } = *hatching;
    if full >= from {
        let message = format!("strokes are most at a light of {full}, and there are none from {from} on");
        let help = "strokes are for the dark: `full` must be below `from`";
        let key = if at.key("full").exists() { "full" } else { "from" };
        at.key(key).error("hatching-light", message, help);
    }
    let (wide, apart) = match (hatching.width, hatching.spacing) {
        (Width::Px(width), Width::Px(spacing)) | (Width::World(width), Width::World(spacing)) => {
            (width, spacing)
        }
        (Width::Px(_), Width::World(_)) | (Width::World(_), Width::Px(_)) => return,
    };
    if wide > apart {
        let message = format!("strokes are {wide} wide, but only {apart} apart");
        let key = if at.key("width").exists() { "width" } else { "spacing" };
        let help = "they run together where it is dark: make `width` at most as large as `spacing`";
        at.key(key).warning("hatching-too-wide", message, help);
    }
}

impl From<AlongFile> for Along {
    fn from(file: AlongFile) -> Self {
        match file {
            AlongFile::Angle => Self::Angle,
            AlongFile::Shade => Self::Shade,
            AlongFile::Light => Self::Light,
            AlongFile::Curvature => Self::Curvature,
        }
    }
}

impl From<FollowFile> for Follow {
    fn from(file: FollowFile) -> Self {
        match file {
            FollowFile::Form => Self::Form,
            FollowFile::Object => Self::Object,
            FollowFile::Screen => Self::Screen,
        }
    }
}
