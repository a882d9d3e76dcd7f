//! Outlines of meshes and surfaces by a larger copy, of which only the far side is drawn.

use super::INK_FORMAT;
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Shell {
    pipeline: RenderPipeline,
}

impl Shell {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("ink/shell"));
        let pipeline = RasterPipeline {
            label: "ink.shell",
            targets: &[INK_FORMAT],
            depth: Some(layers::in_front()),
            ..Default::default()
        };
        Self { pipeline: pipeline.build(&module) }
    }

    /// Adds to `ink` the outlines of the objects of those numbers.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        objects: &[usize],
        layers: &Layers,
        ink: &Transient,
    ) {
        let meshes = subject.meshes;
        let ranges = || objects.iter().map(|&object| meshes.objects[object].clone());
        let counted = || meshes.reserved.iter().filter(|reserved| objects.contains(&reserved.object));
        if ranges().all(|range| range.is_empty()) && counted().next().is_none() {
            return;
        }
        frame.raster(
            "ink.shell",
            &self.pipeline,
            Target::colour(ink, None).with_depth_test(&layers.depth),
            &[
                subject.view.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                subject.lights.as_entire_binding(),
                subject.pens.as_entire_binding(),
                meshes.vertices.as_entire_binding(),
                meshes.triangles.as_entire_binding(),
                meshes.parts.as_entire_binding(),
                meshes.pushes.as_entire_binding(),
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
