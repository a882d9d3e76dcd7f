//! Puts the picture together, cel by cel.

use super::{Backdrop, CEL_FORMAT};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Target, Transient, linear_sampler, shader},
    ink::InkAround,
    shapes::puffs::Subject,
};

/// Pixels along the side of a tile of lines. Also in `lines.wgsl`.
const TILE_PX: u32 = 32;

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Compose {
    /// Averages and blends a cel with its ink.
    compose: wgpu::RenderPipeline,
    /// Lays a backdrop.
    lay: wgpu::RenderPipeline,
    /// Draws ink.
    lines: wgpu::RenderPipeline,
    sampler: wgpu::Sampler,
}

/// The lines of a cel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inked<'a> {
    pub(crate) ink: &'a Transient,
    pub(crate) around: &'a InkAround,
}

/// What a cel is laid over.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Under<'a> {
    Backdrop(&'a Backdrop),
    /// The picture so far.
    Picture(&'a wgpu::TextureView),
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct ComposeUniform {
    samples: u32,
    under: u32,
    cell: f32,
    window: f32,
    size_px: [f32; 2],
    pad: [u32; 2],
}

impl ComposeUniform {
    fn new(size: [u32; 2]) -> Self {
        let size_px = size.map(|pixels| pixels as f32);
        Self { samples: 1, under: 0, cell: 1.0, window: 1.0, size_px, pad: [0; 2] }
    }

    fn inked(self, around: &InkAround) -> Self {
        Self { cell: around.cell as f32, window: around.window(), ..self }
    }
}

impl Compose {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let build = |label, program| {
            let module = gpu.device.create_shader_module(program);
            RasterPipeline { label, targets: &[CEL_FORMAT], ..Default::default() }.build(&gpu.device, &module)
        };
        Self {
            compose: build("tone.compose", shader!("tone/compose")),
            lay: build("tone.lay", shader!("tone/lay")),
            lines: build("tone.lines", shader!("tone/lines")),
            sampler: linear_sampler(gpu),
        }
    }

    /// Lays `cel` and its ink over `under` into `target`; `samples` of the cel's make a side of its pixels.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (cel, Inked { ink, around }): (&Transient, Inked<'_>),
        under: Under<'_>,
        samples: u32,
        target: &wgpu::TextureView,
    ) {
        let (mode, image) = under.image().map_or((0, &**cel), |(mode, image)| (mode, image));
        let size = [cel.texture().width(), cel.texture().height()].map(|side| side / samples);
        let uniform = ComposeUniform { samples, under: mode, ..ComposeUniform::new(size).inked(around) };
        let uniform = frame.uniform("tone.compose.uniform", &uniform);
        frame.fullscreen(
            "tone.compose",
            &self.compose,
            Target::colour(target, Some(wgpu::Color::TRANSPARENT)),
            &[
                uniform.as_entire_binding(),
                subject.pens.as_entire_binding(),
                wgpu::BindingResource::TextureView(cel),
                wgpu::BindingResource::TextureView(ink),
                wgpu::BindingResource::TextureView(&around.layer),
                wgpu::BindingResource::TextureView(image),
                wgpu::BindingResource::Sampler(&self.sampler),
            ],
        );
    }

    /// Lays `under` into `target`, a picture of `size` that is then painted straight into.
    pub(crate) fn lay(
        &self,
        frame: &mut Frame<'_>,
        under: Under<'_>,
        size: [u32; 2],
        target: &wgpu::TextureView,
    ) {
        let clear = match under {
            Under::Backdrop(Backdrop::Colour(colour, _)) => Some(*colour),
            _ => None,
        };
        let Some((mode, image)) = under.image().filter(|_| clear.is_none()) else {
            let clear = clear.unwrap_or(wgpu::Color::TRANSPARENT);
            return frame.clear("tone.lay", Target::colour(target, Some(clear)));
        };
        let uniform = ComposeUniform { under: mode, ..ComposeUniform::new(size) };
        let uniform = frame.uniform("tone.lay.uniform", &uniform);
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

    /// Draws lines into `target`, a picture of `size` that is painted straight into.
    pub(crate) fn lines(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        Inked { ink, around }: Inked<'_>,
        size: [u32; 2],
        target: &wgpu::TextureView,
    ) {
        let uniform = frame.uniform("tone.lines.uniform", &ComposeUniform::new(size).inked(around));
        let tiles = size[0].div_ceil(TILE_PX) * size[1].div_ceil(TILE_PX);
        frame.raster(
            "tone.lines",
            &self.lines,
            Target::colour(target, None),
            &[
                uniform.as_entire_binding(),
                subject.pens.as_entire_binding(),
                wgpu::BindingResource::TextureView(ink),
                wgpu::BindingResource::TextureView(&around.share),
                wgpu::BindingResource::TextureView(&around.layer),
                wgpu::BindingResource::Sampler(&self.sampler),
            ],
            |pass| pass.draw(0..6 * tiles, 0..1),
        );
    }
}

impl<'a> Under<'a> {
    /// The image to lay, if any, and how: 1 stretched over the picture, 2 scaled to cover it.
    fn image(self) -> Option<(u32, &'a wgpu::TextureView)> {
        match self {
            Self::Backdrop(Backdrop::Transparent) => None,
            Self::Backdrop(Backdrop::Colour(_, image) | Backdrop::Gradient(image)) | Self::Picture(image) => {
                Some((1, image))
            }
            Self::Backdrop(Backdrop::Image(image)) => Some((2, image)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: ComposeUniform, "Compose" of "tone/compose" { samples, under, cell, window, size_px });
}
