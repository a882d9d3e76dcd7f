//! Lines along the edges and contours of models, found anew for every view.

use fumetto_scene::EdgeKind;

use super::outline::INK_FORMAT;
use crate::{
    gpu::{
        Compact, Frame, Gpu, Listing, RasterPipeline, Slot, Target, Transient, kernels, shader, workgroups,
    },
    layers::{self, DEPTH_FORMAT, Layers},
    shapes::puffs::Subject,
};

/// Bits of all kinds of edges.
const ALL_KINDS: u32 = (1 << EdgeKind::ALL.len()) - 1;

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Vector {
    edges: wgpu::ComputePipeline,
    strokes: wgpu::RenderPipeline,
}

/// Lines that other lines may cover, or be covered by.
#[derive(Debug)]
pub(crate) struct Lines {
    /// Of [`INK_FORMAT`].
    pub(crate) ink: Transient,
    /// Depth of surfaces, and of the lines where those are nearer.
    pub(crate) depth: Transient,
}

impl Vector {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Read, Slot::Uniform, Slot::Write];
        let [edges] = kernels(gpu, shader!("ink/edges"), &slots, ["main"]);
        let module = gpu.device.create_shader_module(shader!("ink/strip"));
        let strokes = RasterPipeline {
            label: "ink.strip",
            targets: &[INK_FORMAT],
            depth: Some(layers::nearest_wins()),
            ..Default::default()
        };
        Self { edges, strokes: strokes.build(&gpu.device, &module) }
    }

    /// Draws the lines that are seen of the models in `layers`.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        compact: &Compact,
        layers: &Layers,
    ) -> Lines {
        self.find(frame, subject, compact);
        self.stroke(frame, subject, layers)
    }

    /// Lists the candidates whose lines may be seen.
    pub(crate) fn find(&self, frame: &mut Frame<'_>, subject: Subject<'_>, compact: &Compact) {
        let edges = &subject.meshes.edges;
        frame.compute(
            "ink.edges",
            &self.edges,
            &[
                subject.view.as_entire_binding(),
                edges.candidates.as_entire_binding(),
                subject.meshes.vertices.as_entire_binding(),
                subject.pens.as_entire_binding(),
                edges.flags.as_entire_binding(),
            ],
            workgroups(edges.count),
        );
        let listing = Listing { items: edges.count, mask: ALL_KINDS, quads: 1 };
        compact.record(frame, &edges.flags, listing, &edges.list);
    }

    fn stroke(&self, frame: &mut Frame<'_>, subject: Subject<'_>, layers: &Layers) -> Lines {
        let meshes = subject.meshes;
        let lines = Lines {
            ink: frame.texture("ink.lines", layers.size, INK_FORMAT),
            depth: frame.texture("ink.depth", layers.size, DEPTH_FORMAT),
        };
        let (from, to) = (layers.depth.texture(), lines.depth.texture());
        frame.encoder.copy_texture_to_texture(from.as_image_copy(), to.as_image_copy(), from.size());
        frame.raster(
            "ink.strip",
            &self.strokes,
            Target::colour(&lines.ink, Some(wgpu::Color::TRANSPARENT)).with_depth(&lines.depth, None),
            &[
                subject.view.as_entire_binding(),
                meshes.edges.candidates.as_entire_binding(),
                meshes.vertices.as_entire_binding(),
                subject.pens.as_entire_binding(),
                meshes.edges.list.items.as_entire_binding(),
                meshes.triangles.as_entire_binding(),
                meshes.parts.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&layers.depth),
                subject.lights.as_entire_binding(),
            ],
            |pass| meshes.edges.list.draw(pass),
        );
        lines
    }
}
