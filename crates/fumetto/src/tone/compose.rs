//! Puts the picture together, cel by cel.

use super::{Backdrop, CEL_FORMAT};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Region, RenderPipeline, Target, Transient, linear_sampler, shader},
    ink::InkAround,
    shapes::puffs::Subject,
};

/// Pixels along the side of a tile of lines. Also in `lines.wgsl`.
const TILE_PX: u32 = 32;

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Compose {
    /// Averages and blends a cel with its ink.
    compose: RenderPipeline,
    /// Lays a backdrop.
    lay: RenderPipeline,
    /// Draws ink.
    lines: RenderPipeline,
    sampler: wgpu::Sampler,
}

/// The lines of a cel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inked<'a> {
    pub(crate) ink: &'a Transient,
    /// In what is drawn.
    pub(crate) around: &'a InkAround,
    /// In the whole picture, where that is known from elsewhere, and the side of its cells in samples of what
    /// is drawn.
    pub(crate) known: Option<(&'a InkAround, f32)>,
}

/// What is drawn of a picture, and how finely.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sheet {
    pub(crate) region: Region,
    /// Along each side of a pixel.
    pub(crate) samples: u32,
}

/// What a cel is laid over.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Under<'a> {
    Backdrop(&'a Backdrop),
    /// The same in shades of grey.
    GreyBackdrop(&'a Backdrop),
    /// The picture so far, as large as what is drawn.
    Picture(&'a wgpu::TextureView),
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct ComposeUniform {
    samples: u32,
    under: u32,
    cell: f32,
    window: f32,
    size_px: [f32; 2],
    laid_px: [f32; 2],
    first_px: [f32; 2],
    around_cell: f32,
    is_grey: u32,
}

impl ComposeUniform {
    pub(super) fn new(Sheet { region, samples }: Sheet, under: Under<'_>) -> Self {
        let pixels = |side: [u32; 2]| side.map(|side| (side / samples) as f32);
        let (size_px, laid_px) = match under {
            Under::Backdrop(_) | Under::GreyBackdrop(_) => (pixels(region.picture), pixels(region.first)),
            Under::Picture(_) => (pixels(region.size), [0.0; 2]),
        };
        let first_px = region.first.map(|side| side as f32);
        let mode = under.image().map_or(0, |(mode, _)| mode);
        let (cell, window, around_cell) = (1.0, 1.0, 1.0);
        let is_grey = u32::from(matches!(under, Under::GreyBackdrop(_)));
        Self { samples, under: mode, cell, window, size_px, laid_px, first_px, around_cell, is_grey }
    }

    /// Of what is drawn alone, if nothing is known of the rest.
    pub(super) fn inked(self, Inked { around, known, .. }: Inked<'_>) -> Self {
        let cell = around.cell as f32;
        match known {
            Some((_, around_cell)) => {
                Self { cell, around_cell, window: InkAround::window(around_cell), ..self }
            }
            None => {
                Self { cell, around_cell: cell, window: InkAround::window(cell), first_px: [0.0; 2], ..self }
            }
        }
    }
}

impl<'a> Inked<'a> {
    /// How much ink there is around.
    pub(super) fn around(&self) -> &'a Transient {
        &self.known.map_or(self.around, |(known, _)| known).layer
    }
}

impl Compose {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let build = |label, program| {
            let module = gpu.module(program);
            RasterPipeline { label, targets: &[CEL_FORMAT], ..Default::default() }.build(&module)
        };
        Self {
            compose: build("tone.compose", shader!("tone/compose")),
            lay: build("tone.lay", shader!("tone/lay")),
            lines: build("tone.lines", shader!("tone/lines")),
            sampler: linear_sampler(gpu),
        }
    }

    /// Lays `cel` and its ink over `under` into `target`.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (cel, inked): (&Transient, Inked<'_>),
        under: Under<'_>,
        sheet: Sheet,
        target: &wgpu::TextureView,
    ) {
        let image = under.image().map_or(&**cel, |(_, image)| image);
        let uniform = ComposeUniform::new(sheet, under).inked(inked);
        let uniform = frame.uniform("tone.compose.uniform", &uniform);
        frame.fullscreen(
            "tone.compose",
            &self.compose,
            Target::colour(target, Some(wgpu::Color::TRANSPARENT)),
            &[
                uniform.as_entire_binding(),
                subject.pens.as_entire_binding(),
                wgpu::BindingResource::TextureView(cel),
                wgpu::BindingResource::TextureView(inked.ink),
                wgpu::BindingResource::TextureView(inked.around()),
                wgpu::BindingResource::TextureView(image),
                wgpu::BindingResource::Sampler(&self.sampler),
            ],
        );
    }

    /// Lays `under` into `target`, a picture that is then painted straight into.
    pub(crate) fn lay(
        &self,
        frame: &mut Frame<'_>,
        under: Under<'_>,
        sheet: Sheet,
        target: &wgpu::TextureView,
    ) {
        let clear = match under {
            Under::Backdrop(Backdrop::Colour(colour, _)) => Some(*colour),
            _ => None,
        };
        let Some((_, image)) = under.image().filter(|_| clear.is_none()) else {
            let clear = clear.unwrap_or(wgpu::Color::TRANSPARENT);
            return frame.clear("tone.lay", Target::colour(target, Some(clear)));
        };
        let uniform = frame.uniform("tone.lay.uniform", &ComposeUniform::new(sheet, under));
        frame.fullscreen(
            "tone.lay",
            &self.lay,
            Target::colour(target, Some(wgpu::Color::TRANSPARENT)),
            &[
                uniform.as_entire_binding(),
                wgpu::BindingResource::TextureView(image),
                wgpu::BindingResource::Sampler(&self.sampler),
            ],
        );
    }

    /// Draws lines into `target`, a picture that is painted straight into.
    pub(crate) fn lines(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        inked: Inked<'_>,
        sheet: Sheet,
        target: &wgpu::TextureView,
    ) {
        let nothing = Under::Backdrop(&Backdrop::Transparent);
        let uniform = frame.uniform("tone.lines.uniform", &ComposeUniform::new(sheet, nothing).inked(inked));
        let size = sheet.region.size;
        let tiles = size[0].div_ceil(TILE_PX) * size[1].div_ceil(TILE_PX);
        frame.raster(
            "tone.lines",
            &self.lines,
            Target::colour(target, None),
            &[
                uniform.as_entire_binding(),
                subject.pens.as_entire_binding(),
                wgpu::BindingResource::TextureView(inked.ink),
                wgpu::BindingResource::TextureView(&inked.around.share),
                wgpu::BindingResource::TextureView(inked.around()),
                wgpu::BindingResource::Sampler(&self.sampler),
            ],
            |pass| pass.draw(0..6 * tiles, 0..1),
        );
    }
}

impl<'a> Under<'a> {
    /// The image to lay, if any, and how: 1 stretched over the picture, 2 scaled to cover it,
    /// 3 repeated.
    fn image(self) -> Option<(u32, &'a wgpu::TextureView)> {
        let backdrop = match self {
            Self::Backdrop(backdrop) | Self::GreyBackdrop(backdrop) => backdrop,
            Self::Picture(image) => return Some((1, image)),
        };
        match backdrop {
            Backdrop::Transparent => None,
            Backdrop::Colour(_, image) | Backdrop::Gradient(image) => Some((1, image)),
            Backdrop::Image(image) => Some((2, image)),
            Backdrop::Paper(image) => Some((3, image)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: ComposeUniform, "Compose" of "tone/compose" { samples, under, cell, window, size_px, laid_px, first_px, around_cell, is_grey });
}
