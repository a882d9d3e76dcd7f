//! How much ink there is around each place.

use crate::gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader};

/// Share of a cell that is inked; then 1 where any of it is.
const SHARE_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg8Unorm;

/// Mean share of the cells around one.
const AROUND_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R8Unorm;

/// Cells to each side of the window. Also in `around.wgsl`.
const WINDOW_CELLS: u32 = 5;

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Gather {
    share: RenderPipeline,
    around: RenderPipeline,
}

/// Ink around each cell of the picture.
#[derive(Debug)]
pub(crate) struct InkAround {
    pub(crate) layer: Transient,
    /// Share of each cell that is inked, and whether any of it is.
    pub(crate) share: Transient,
    /// Pixels along the side of a cell.
    pub(crate) cell: u32,
}

impl InkAround {
    /// Area of the window that is summed over where a cell is `cell` pixels wide, in pixels.
    pub(crate) fn window(cell: f32) -> f32 {
        (WINDOW_CELLS as f32 * cell).powi(2)
    }
}

impl Gather {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let build = |program, label, format| {
            let module = gpu.module(program);
            RasterPipeline { label, targets: &[format], ..Default::default() }.build(&module)
        };
        Self {
            share: build(shader!("ink/share"), "ink.share", SHARE_FORMAT),
            around: build(shader!("ink/around"), "ink.around", AROUND_FORMAT),
        }
    }

    /// Sums `ink`, a layer of `size`, in windows about twice as wide as `length_px`: a line of that length
    /// is all inside one around its middle, and half of a longer one is inside one around its end.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        ink: &Transient,
        size: [u32; 2],
        length_px: f32,
    ) -> InkAround {
        let cell = ((2.0 * length_px / WINDOW_CELLS as f32).round() as u32).clamp(2, 256);
        let cells = size.map(|pixels| pixels.div_ceil(cell));
        let share = frame.texture("ink.share", cells, SHARE_FORMAT);
        let uniform = frame.uniform("ink.share.uniform", &[cell, 0, 0, 0]);
        frame.fullscreen(
            "ink.share",
            &self.share,
            Target::colour(&share, Some(wgpu::Color::TRANSPARENT)),
            &[uniform.as_entire_binding(), wgpu::BindingResource::TextureView(ink)],
        );
        let around = frame.texture("ink.around", cells, AROUND_FORMAT);
        frame.fullscreen(
            "ink.around",
            &self.around,
            Target::colour(&around, Some(wgpu::Color::TRANSPARENT)),
            &[wgpu::BindingResource::TextureView(&share)],
        );
        InkAround { layer: around, share, cell }
    }
}
