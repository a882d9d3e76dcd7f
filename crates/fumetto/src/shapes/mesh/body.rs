//! Draws triangles into the depth and id layers.

use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Target, shader},
    layers,
    shapes::puffs::Subject,
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Body {
    pipeline: wgpu::RenderPipeline,
}

impl Body {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("shapes/mesh/body"));
        let pipeline = RasterPipeline {
            label: "shapes.mesh.body",
            targets: &[layers::ID_FORMAT],
            depth: Some(layers::nearest_wins()),
            ..Default::default()
        };
        Self { pipeline: pipeline.build(&gpu.device, &module) }
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
        if ranges().all(|range| range.is_empty()) {
            return;
        }
        frame.raster(
            "shapes.mesh.body",
            &self.pipeline,
            target,
            &[
                subject.view.as_entire_binding(),
                meshes.vertices.as_entire_binding(),
                meshes.triangles.as_entire_binding(),
            ],
            |pass| {
                for range in ranges() {
                    pass.draw(3 * range.start..3 * range.end, 0..1);
                }
            },
        );
    }
}
