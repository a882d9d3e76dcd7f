//! Lengths on a picture that all its passes share. They come of the whole picture's height, also where a tile of
//! it is drawn.

use fumetto_scene::{Hatching, Object};

use crate::{
    Player,
    ink::{self, Methods},
    player::Look,
    tone::TURNS_PX,
};

/// Shadows are cleaned over this many times the length that tones are: their specks come of single puffs,
/// which are larger than the bumps on them.
pub(crate) const SETTLE: f32 = 3.0;

/// Most that a form is smoothed over for strokes, in heights of the picture: each sample looks at all around it.
const SMOOTHEST: f32 = 0.125;

/// Relief that is always smoothed over before strokes run round a form, in pixels of the style: how small
/// bumps bend says nothing.
const CURVED_PX: f32 = 4.0;

/// Samples along a texel of the coarsest layer, and of those around it that it is mixed with.
const TEXELS_PX: f32 = 8.0;

/// Least size of a tone's shape in a picture `height_px` samples high, in samples: the largest that any object
/// wants.
pub(crate) fn clean_px(objects: &[&Object], height_px: u32) -> f32 {
    let px = |object: &&Object| object.style.clean_px * height_px as f32 / object.style.height_px;
    objects.iter().map(px).fold(0.0, f32::max)
}

/// Least size of relief that bends strokes, in samples: the largest that any object wants; `None` where nothing
/// is hatched.
pub(crate) fn smooth_px(objects: &[&Object], height_px: u32) -> Option<f32> {
    let hatched = objects.iter().filter(|object| object.visible && object.style.hatching.on);
    let px = |object: &&Object| {
        let Hatching { smooth_px, .. } = object.style.hatching;
        let least_px = if object.style.hatching.follows_curvature() { CURVED_PX } else { 0.0 };
        smooth_px.max(least_px) * height_px as f32 / object.style.height_px
    };
    hatched.map(px).reduce(f32::max).map(|px| px.min(SMOOTHEST * height_px as f32))
}

/// Whether any strokes run as the form bends.
pub(crate) fn wants_turns(objects: &[&Object]) -> bool {
    objects.iter().any(|object| object.visible && object.style.hatching.follows_curvature())
}

/// How far from a pixel of a picture `height_px` samples high anything may lie that it depends on, in samples;
/// the lengths of lines aside, which only a survey tells.
pub(crate) fn reach_px(player: &Player, height_px: u32) -> f32 {
    let reach = |look: &Look| look_reach_px(&look.drawn().iter().collect::<Vec<_>>(), height_px);
    player.looks.iter().map(reach).fold(0.0, f32::max)
}

fn look_reach_px(objects: &[&Object], height_px: u32) -> f32 {
    let members: Vec<usize> = (0..objects.len()).collect();
    let methods = Methods::of(objects, &members, height_px);
    // A flood jumps up to twice as far as it reaches; a line asks what hides its middle.
    let widths = if methods.image || methods.hybrid { 2.0 } else { 1.0 };
    let strokes = objects.iter().map(|object| ink::reach_px(object, height_px)).fold(0.0, f32::max);
    // It is smoothed in two rounds.
    let smooth = smooth_px(objects, height_px).map_or(0.0, |px| 1.5 * px + TEXELS_PX);
    let smooth = smooth + if wants_turns(objects) { TURNS_PX + TEXELS_PX } else { 0.0 };
    (SETTLE * clean_px(objects, height_px)).max(widths * methods.radius_px).max(smooth).max(strokes)
        + TEXELS_PX
}
