//! Outlines by ink billboards behind the puffs.

use super::Lines;
use crate::{
    gpu::{DrawList, Frame, Gpu, RasterPipeline, Target, Transient, shader},
    layers::{self, Layers},
    shapes::puffs::{Atlas, Subject},
};

/// Number of the pen + 1, 0 where there is no ink; opacity of the line, 0 to 255.
pub(crate) const INK_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg8Uint;

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Outline {
    pipeline: wgpu::RenderPipeline,
}

impl Outline {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("ink/outline"));
        let pipeline = RasterPipeline {
            label: "ink.outline",
            targets: &[INK_FORMAT],
            depth: Some(layers::in_front()),
            ..Default::default()
        };
        Self { pipeline: pipeline.build(&gpu.device, &module) }
    }

    /// Inks the listed puffs, among `lines` where there are any.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        list: &DrawList,
        layers: &Layers,
        lines: Option<Lines>,
    ) -> Transient {
        let (ink, depth) = lines.map_or_else(
            || (frame.texture("ink.outline", layers.size, INK_FORMAT), None),
            |lines| (lines.ink, Some(lines.depth)),
        );
        let clear = depth.is_none().then_some(wgpu::Color::TRANSPARENT);
        let Atlas { view: texture, sampler, uniform, .. } = &subject.scene.atlas;
        frame.raster(
            "ink.outline",
            &self.pipeline,
            Target::colour(&ink, clear).with_depth_test(depth.as_ref().unwrap_or(&layers.depth)),
            &[
                subject.view.as_entire_binding(),
                uniform.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                list.items.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                subject.lights.as_entire_binding(),
                wgpu::BindingResource::TextureView(texture),
                wgpu::BindingResource::Sampler(sampler),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&layers.depth),
            ],
            |pass| list.draw(pass),
        );
        ink
    }
}
