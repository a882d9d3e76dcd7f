//! Lines where neighbouring pixels show different things.

use super::{
    INK_FORMAT, Methods,
    flood::{Flood, SEED_FORMAT, tiles},
};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// 1 where a border runs through a tile.
const BORDERS_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R8Unorm;

/// Pixels along the side of a tile that lines are looked for in. Also in `tiles.wgsl`.
const LOOK_TILE_PX: u32 = 16;

/// `Image` of `image.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct ImageUniform {
    radius_px: f32,
    first: u32,
    pad: [u32; 2],
}

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Image {
    /// Of whole pieces, and of single triangles.
    borders: [RenderPipeline; 2],
    find: RenderPipeline,
    flood: Flood,
    draw: RenderPipeline,
}

impl Image {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let build = |program, pipeline: RasterPipeline<'_>| {
            let module = gpu.module(program);
            pipeline.build(&module)
        };
        let borders = [0.0, 1.0].map(|has_image| {
            let constants = [("HAS_IMAGE", has_image)];
            let targets = &[BORDERS_FORMAT];
            let pipeline =
                RasterPipeline { label: "ink.borders", targets, constants: &constants, ..Default::default() };
            build(shader!("ink/borders"), pipeline)
        });
        let depth = Some(layers::where_filled());
        let find =
            RasterPipeline { label: "ink.image", targets: &[SEED_FORMAT], depth, ..Default::default() };
        let draw = RasterPipeline { label: "ink.flooded", targets: &[INK_FORMAT], ..Default::default() };
        let (find, draw) = (build(shader!("ink/image"), find), build(shader!("ink/flooded"), draw));
        Self { borders, find, flood: Flood::new(gpu), draw }
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
        let seeds = self.find(frame, subject, methods, layers, (ink, &tiles_found));
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
        methods: &Methods,
        layers: &Layers,
        (ink, tiles): (&Transient, &wgpu::Buffer),
    ) -> Transient {
        let meshes = subject.meshes;
        let tiled = layers.size.map(|pixels| pixels.div_ceil(LOOK_TILE_PX));
        let borders = frame.texture("ink.borders", tiled, BORDERS_FORMAT);
        frame.fullscreen(
            "ink.borders",
            &self.borders[usize::from(methods.image)],
            Target::colour(&borders, Some(wgpu::Color::TRANSPARENT)),
            &[
                meshes.triangles.as_entire_binding(),
                meshes.parts.as_entire_binding(),
                meshes.pieces.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.id),
            ],
        );
        let seeds = frame.texture("ink.image", layers.size, SEED_FORMAT);
        let uniform = frame.uniform(
            "ink.image.uniform",
            &ImageUniform { radius_px: methods.radius_px, first: methods.first as u32, pad: [0; 2] },
        );
        frame.raster(
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
                wgpu::BindingResource::TextureView(&borders),
            ],
            |pass| pass.draw(0..6 * tiled[0] * tiled[1], 0..1),
        );
        seeds
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: ImageUniform, "Image" of "ink/image" { radius_px, first });
}
