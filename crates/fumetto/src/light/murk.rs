//! Shadows that volumes throw on other things.
//!
//! From every place that is seen a ray goes through the field toward each light, as from cells of light within it: so
//! the shadow on the ground has the shape of the cloud, and not of a box of cells around it.

use super::{LightsUniform, shadows::SHADOW_FORMAT};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, linear_sampler, shader},
    layers::Layers,
    shapes::{
        puffs::Subject,
        volume::{Field, VolumeScene},
    },
};

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Murk {
    of_cells: RenderPipeline,
    of_bricks: RenderPipeline,
    linear: wgpu::Sampler,
}

impl Murk {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let build = |label, program| {
            let module = gpu.module(program);
            RasterPipeline { label, targets: &[SHADOW_FORMAT], ..Default::default() }.build(&module)
        };
        Self {
            of_cells: build("light.murk", shader!("light/murk")),
            of_bricks: build("light.murk_bricks", shader!("light/murk_bricks")),
            linear: linear_sampler(gpu),
        }
    }

    /// Adds to `shadow` which lights volumes keep away from what `layers` show of others.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (volumes, lights): (&VolumeScene, &LightsUniform),
        layers: &Layers,
        shadow: Transient,
    ) -> Transient {
        let mut shadow = shadow;
        if lights.casting().next().is_none() {
            return shadow;
        }
        for (recipe, field) in volumes.casting() {
            let recipe = frame.uniform("shapes.volume.recipe", &recipe);
            let view = |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
            let (label, pipeline, [grid, spaces], density) = match field {
                Field::Cells(field) => {
                    ("light.murk", &self.of_cells, [&field.grid, &field.occupied], view(&field.density))
                }
                Field::Bricks(field) => {
                    ("light.murk_bricks", &self.of_bricks, [&field.grid, &field.table], view(&field.atlas))
                }
            };
            let sum = frame.texture("light.shadow", layers.size, SHADOW_FORMAT);
            let bindings = [
                subject.view.as_entire_binding(),
                recipe.as_entire_binding(),
                wgpu::BindingResource::Sampler(&self.linear),
                grid.as_entire_binding(),
                spaces.as_entire_binding(),
                wgpu::BindingResource::TextureView(&density),
                subject.lights.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.depth),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&shadow),
            ];
            let target = Target::colour(&sum, Some(wgpu::Color::TRANSPARENT));
            frame.fullscreen(label, pipeline, target, &bindings);
            shadow = sum;
        }
        shadow
    }
}
