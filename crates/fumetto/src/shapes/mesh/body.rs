//! Draws triangles into the depth and id layers.

use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, shader},
    layers,
    shapes::puffs::Subject,
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Body {
    /// For whole surfaces, and for those with holes.
    pipelines: [RenderPipeline; 2],
}

impl Body {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("shapes/mesh/body"));
        let pipelines = [0.0, 1.0].map(|has_holes| {
            let pipeline = RasterPipeline {
                label: "shapes.mesh.body",
                targets: &[layers::ID_FORMAT],
                depth: Some(layers::nearest_wins()),
                constants: &[("HAS_HOLES", has_holes)],
                ..Default::default()
            };
            pipeline.build(&module)
        });
        Self { pipelines }
    }

    /// Draws the triangles of the objects that `members` numbers over what `target` holds.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        members: &[usize],
        target: Target<'_>,
    ) {
        let meshes = subject.meshes;
        let ranges = || members.iter().map(|&member| meshes.objects[member].clone());
        let counted = || meshes.reserved.iter().filter(|reserved| members.contains(&reserved.object));
        if ranges().all(|range| range.is_empty()) && counted().next().is_none() {
            return;
        }
        frame.raster(
            "shapes.mesh.body",
            &self.pipelines[usize::from(meshes.has_holes)],
            target,
            &[
                subject.view.as_entire_binding(),
                meshes.sources.as_entire_binding(),
                meshes.vertices.as_entire_binding(),
                meshes.triangles.as_entire_binding(),
                meshes.parts.as_entire_binding(),
                wgpu::BindingResource::TextureView(&meshes.textures),
                wgpu::BindingResource::Sampler(&meshes.sampler),
            ],
            |pass| {
                for range in ranges() {
                    pass.draw(3 * range.start..3 * range.end, 0..1);
                }
                for reserved in counted() {
                    pass.draw_indirect(&reserved.counters, 0);
                }
            },
        );
    }
}
