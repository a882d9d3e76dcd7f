use std::path::Path;

use anyhow::Context as _;
use fumetto_formats::{GifWriter, write_png};
use fumetto_scene::{Background, Colour, EdgeKind, Ramp, Scene};

use super::{DrawTile, Drawing, Picture, Plan};
use crate::args::TargetKind;
use fumetto_disk::{self as disk, Draft};

/// Where finished frames go.
pub(crate) enum Sink {
    /// A file for each frame, and one for each of its layers.
    Pictures {
        /// Whether none of them has a transparent pixel.
        opaque: bool,
    },
    /// One file, which gets its name when the last frame is in it.
    Animation(Box<GifWriter<Draft>>),
}

impl Sink {
    /// Opens what can be opened before the first frame is drawn, so that a wrong name costs nothing.
    pub(crate) fn open(plan: &Plan, scene: &Scene) -> anyhow::Result<Self> {
        let name = &plan.target.name;
        match plan.target.kind {
            TargetKind::Animation => {
                let draft = Draft::new(Path::new(name))?;
                let [width, height] = plan.shot.size;
                let transparent = scene.background == Background::Transparent;
                let keep = flat_colours(scene);
                let gif = GifWriter::new(draft, width, height, scene.time.fps, transparent, &keep)
                    .with_context(|| format!("cannot write {name}"))?;
                Ok(Self::Animation(Box::new(gif)))
            }
            TargetKind::Picture | TargetKind::Sequence => {
                disk::check(Path::new(&plan.file(plan.frames.first)))?;
                let opaque = matches!(
                    scene.background,
                    Background::Colour(_) | Background::Gradient { .. } | Background::Paper(_)
                );
                Ok(Self::Pictures { opaque })
            }
        }
    }

    /// Writes a frame.
    pub(crate) fn write(
        &mut self,
        plan: &Plan,
        frame: u32,
        drawing: &mut Drawing,
        draw_tile: DrawTile<'_>,
    ) -> anyhow::Result<()> {
        match self {
            // The picture comes last: where it is, --resume can rely on its layers.
            Self::Pictures { opaque } => {
                for (&layer, image) in plan.layers.iter().zip(&drawing.layers) {
                    disk::write(Path::new(&plan.layer_file(frame, layer)), |draft| write_png(image, draft))?;
                }
                drawing.picture.write(&plan.file(frame), (plan.shot.size, *opaque), draw_tile)
            }
            Self::Animation(gif) => {
                let Picture::Drawn(picture) = &drawing.picture else { return Ok(()) };
                gif.push(picture).with_context(|| format!("cannot write {}", plan.target.name))
            }
        }
    }

    /// Completes what is still open.
    pub(crate) fn finish(self, plan: &Plan) -> anyhow::Result<()> {
        match self {
            Self::Pictures { .. } => Ok(()),
            Self::Animation(gif) => {
                let draft = gif.finish().with_context(|| format!("cannot write {}", plan.target.name))?;
                draft.publish()
            }
        }
    }
}

/// The colours that someone picked, and that an animation's palette has to keep.
fn flat_colours(scene: &Scene) -> Vec<[u8; 3]> {
    let mut picked: Vec<Colour> = Vec::new();
    for style in (0..scene.objects.len()).flat_map(|object| scene.styles_of(object)) {
        if let Ramp::Tones(tones) = &style.ramp {
            picked.extend(tones.iter().map(|tone| tone.colour));
        }
        picked.extend(style.highlight.on.then_some(style.highlight.colour));
        picked.extend(style.rim.on.then_some(style.rim.colour));
        picked.extend(style.hatching.on.then_some(style.hatching.colour));
        picked.extend(EdgeKind::ALL.map(|kind| style.ink.colour_of(kind)));
    }
    picked.extend(scene.paints().filter_map(|(_, paint)| Some(paint.border.as_ref()?.colour)));
    if let Background::Colour(colour) = scene.background {
        picked.push(colour);
    }
    picked.into_iter().map(Colour::to_srgb8).collect()
}
