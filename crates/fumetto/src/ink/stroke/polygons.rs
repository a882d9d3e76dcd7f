//! Draws strokes.

use super::{Drawing, StrokeRoom, TOOTH_SIDE};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader},
    ink::INK_FORMAT,
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// Height of a picture on which a texel of the paper's tooth is as large as a pixel.
pub(crate) const PAPER_HEIGHT: f32 = 720.0;

/// The long-lived pipeline.
#[derive(Debug)]
pub(super) struct Polygons {
    pipeline: RenderPipeline,
    sampler: wgpu::Sampler,
}

impl Polygons {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("ink/stroke/polygon"));
        let pipeline = RasterPipeline {
            label: "ink.stroke.polygon",
            targets: &[INK_FORMAT],
            depth: Some(layers::nearest_wins()),
            ..Default::default()
        };
        let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("ink.stroke.repeating"),
            address_mode_u: wgpu::AddressMode::Repeat,
            // A stroke's texture is clear at its edges, a sheet of paper goes on.
            address_mode_v: wgpu::AddressMode::Repeat,
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: wgpu::MipmapFilterMode::Linear,
            ..Default::default()
        });
        Self { pipeline: pipeline.build(&module), sampler }
    }

    pub(super) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (drawing, room): (&Drawing<'_>, &StrokeRoom),
        styles: &wgpu::Buffer,
        layers: &Layers,
        (ink, depth): (&Transient, &Transient),
    ) {
        let &Drawing { textures, picture_height, .. } = drawing;
        let paper = [PAPER_HEIGHT / picture_height as f32, 0.0, 0.0, 0.0];
        let paper = frame.uniform("ink.stroke.paper", &paper);
        frame.raster(
            "ink.stroke.polygon",
            &self.pipeline,
            Target::colour(ink, None).with_depth(depth, None),
            &[
                subject.view.as_entire_binding(),
                styles.as_entire_binding(),
                subject.pens.as_entire_binding(),
                room.joints.as_entire_binding(),
                room.shapes.as_entire_binding(),
                subject.meshes.triangles.as_entire_binding(),
                subject.meshes.parts.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&layers.depth),
                wgpu::BindingResource::TextureView(&textures.strokes),
                wgpu::BindingResource::TextureView(&textures.tooth),
                wgpu::BindingResource::Sampler(&self.sampler),
                paper.as_entire_binding(),
            ],
            |pass| pass.draw_indirect(&room.draw, 0),
        );
    }
}

const _: () = assert!(TOOTH_SIDE.is_power_of_two(), "its mip levels are whole");
