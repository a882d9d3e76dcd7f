//! Lines where neighbouring pixels show different things.

use super::{
    INK_FORMAT, Methods,
    flood::{Flood, SEED_FORMAT, tiles},
};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Target, Transient, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Image {
    find: wgpu::RenderPipeline,
    flood: Flood,
    draw: wgpu::RenderPipeline,
}

impl Image {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let build = |label, program, format, depth| {
            let module = gpu.device.create_shader_module(program);
            RasterPipeline { label, targets: &[format], depth, ..Default::default() }
                .build(&gpu.device, &module)
        };
        Self {
            find: build("ink.image", shader!("ink/image"), SEED_FORMAT, Some(layers::where_filled())),
            flood: Flood::new(gpu),
            draw: build("ink.flooded", shader!("ink/flooded"), INK_FORMAT, None),
        }
    }

    /// Adds the lines that are found in the picture to `ink`, which tells where there are others.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        methods: &Methods,
        layers: &Layers,
        ink: &Transient,
    ) {
        let meets = methods.hybrid && !subject.meshes.is_empty();
        if !methods.image && !meets {
            return;
        }
        let tiles_found = frame.zeros("ink.image.tiles", tiles(layers.size));
        let seeds = self.find(frame, subject, methods.radius_px, layers, (ink, &tiles_found));
        let flooded = self.flood.record(frame, seeds, layers.size, &tiles_found, methods.radius_px);
        frame.raster(
            "ink.flooded",
            &self.draw,
            Target::colour(ink, None),
            &[
                subject.view.as_entire_binding(),
                tiles_found.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                subject.meshes.triangles.as_entire_binding(),
                subject.meshes.parts.as_entire_binding(),
                wgpu::BindingResource::TextureView(&flooded),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&layers.depth),
            ],
            |pass| pass.draw(0..6 * tiles(layers.size), 0..1),
        );
    }

    /// Finds the places that lines run through, and the tiles that these reach.
    fn find(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        radius_px: f32,
        layers: &Layers,
        (ink, tiles): (&Transient, &wgpu::Buffer),
    ) -> Transient {
        let seeds = frame.texture("ink.image", layers.size, SEED_FORMAT);
        let uniform = frame.uniform("ink.image.uniform", &[radius_px, 0.0, 0.0, 0.0]);
        let meshes = subject.meshes;
        frame.fullscreen(
            "ink.image",
            &self.find,
            Target::colour(&seeds, Some(wgpu::Color::TRANSPARENT)).with_depth_test(&layers.depth),
            &[
                subject.view.as_entire_binding(),
                uniform.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                subject.lights.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                subject.pens.as_entire_binding(),
                meshes.vertices.as_entire_binding(),
                meshes.triangles.as_entire_binding(),
                meshes.parts.as_entire_binding(),
                meshes.pieces.as_entire_binding(),
                tiles.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&layers.depth),
                wgpu::BindingResource::TextureView(ink),
            ],
        );
        seeds
    }
}
