//! Rays through volumes, for one picture.

use super::{
    field::{Field, view},
    scene::{Made, VolumeScene},
};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Target, linear_sampler, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct March {
    march: wgpu::RenderPipeline,
    march_bricks: wgpu::RenderPipeline,
    place: wgpu::RenderPipeline,
    linear: wgpu::Sampler,
}

impl March {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let build = |program, pipeline: RasterPipeline<'_>| {
            pipeline.build(&gpu.device, &gpu.device.create_shader_module(program))
        };
        let targets = &[layers::HITS_FORMAT, layers::LIGHT_FORMAT, layers::SOFT_FORMAT];
        let march = |label| RasterPipeline { label, targets, ..Default::default() };
        let place = RasterPipeline {
            label: "shapes.volume.place",
            targets: &[layers::ID_FORMAT],
            depth: Some(layers::nearest_wins()),
            ..Default::default()
        };
        Self {
            march: build(shader!("shapes/volume/march"), march("shapes.volume.march")),
            march_bricks: build(shader!("shapes/volume/bricks/march"), march("shapes.volume.bricks.march")),
            place: build(shader!("shapes/volume/place"), place),
            linear: linear_sampler(gpu),
        }
    }

    /// Follows every pixel's ray through the volumes of the objects that `members` numbers, one after the other,
    /// up to what the layers hold; and brings the surfaces that it meets into the layers.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (scene, members): (&VolumeScene, &[usize]),
        layers: &mut Layers,
    ) {
        for (number, volume) in scene.of(members).enumerate() {
            if number == 0 {
                layers.add_volumes(frame);
            }
            self.march(frame, subject, volume, layers, number == 0);
            frame.fullscreen(
                "shapes.volume.place",
                &self.place,
                layers.target(),
                &[wgpu::BindingResource::TextureView(&layers.hits)],
            );
        }
    }

    fn march(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        volume: &Made,
        layers: &Layers,
        first: bool,
    ) {
        let recipe = frame.uniform("shapes.volume.recipe", &volume.recipe.uniform(0.0));
        let clear = first.then_some(wgpu::Color::TRANSPARENT);
        let colours = vec![(&*layers.hits, clear), (&*layers.light, clear), (&*layers.soft, clear)];
        let target = Target { colours, depth: None };
        let (label, pipeline, [grid, spaces], [density, transmitted]) = match &volume.field {
            Field::Cells(field) => {
                let textures = [&field.density, &field.transmitted].map(view);
                ("shapes.volume.march", &self.march, [&field.grid, &field.occupied], textures)
            }
            Field::Bricks(field) => {
                let textures = [&field.atlas, &field.transmitted].map(view);
                ("shapes.volume.bricks.march", &self.march_bricks, [&field.grid, &field.table], textures)
            }
        };
        let mut bindings = vec![
            subject.view.as_entire_binding(),
            recipe.as_entire_binding(),
            wgpu::BindingResource::Sampler(&self.linear),
            grid.as_entire_binding(),
            spaces.as_entire_binding(),
            wgpu::BindingResource::TextureView(&density),
            subject.lights.as_entire_binding(),
            wgpu::BindingResource::TextureView(&transmitted),
            wgpu::BindingResource::TextureView(&layers.depth),
        ];
        let owners = volume.field.owners().map(view);
        bindings.extend(owners.as_ref().map(wgpu::BindingResource::TextureView));
        frame.fullscreen(label, pipeline, target, &bindings);
    }
}
