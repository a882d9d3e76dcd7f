//! Layers in which the lines of inner surfaces are found.

use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Transient, shader},
    layers::{self, ID_FORMAT, Layers},
    shapes::{mesh, puffs::Subject},
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Inner {
    others: RenderPipeline,
}

impl Inner {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("ink/others"));
        let pipeline = RasterPipeline {
            label: "ink.others",
            targets: &[ID_FORMAT],
            depth: Some(layers::nearest_wins()),
            ..Default::default()
        };
        Self { others: pipeline.build(&module) }
    }

    /// Layers of the surfaces that `members` numbers, which lie inside others at one `level`, and of what else
    /// `layers` show, but not of what they lie inside. `nearer` is as in [`Layers::begin`].
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        body: &mesh::Body,
        (level, members): (usize, &[usize]),
        (layers, nearer): (&Layers, Option<&Transient>),
    ) -> Layers {
        let mut inner = Layers::new(frame, layers.size);
        inner.begin(frame, nearer);
        let level = frame.uniform("ink.others.level", &[level as u32, 0, 0, 0]);
        frame.fullscreen(
            "ink.others",
            &self.others,
            inner.target(),
            &[
                level.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                subject.meshes.triangles.as_entire_binding(),
                subject.meshes.parts.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&layers.depth),
            ],
        );
        body.record(frame, subject, members, inner.target());
        inner
    }
}
