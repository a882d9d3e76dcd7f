//! Lines along the edges and contours of models and surfaces, found anew for every view.

use fumetto_scene::EdgeKind;

use super::INK_FORMAT;
use crate::{
    gpu::{
        Compact, ComputePipeline, Frame, Gpu, Listing, RasterPipeline, RenderPipeline, Slot, Target,
        Transient, kernels, shader, workgroups,
    },
    layers::{self, DEPTH_FORMAT, Layers},
    shapes::{mesh::LineScene, puffs::Subject},
};

/// Bits of all kinds of edges.
const ALL_KINDS: u32 = (1 << EdgeKind::ALL.len()) - 1;

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Vector {
    models: Pipelines,
    surfaces: Pipelines,
}

#[derive(Debug)]
struct Pipelines {
    find: ComputePipeline,
    stroke: RenderPipeline,
}

impl Pipelines {
    fn new(
        gpu: &Gpu,
        find: wgpu::ShaderModuleDescriptor<'static>,
        stroke: wgpu::ShaderModuleDescriptor<'static>,
    ) -> Self {
        let slots =
            [Slot::Uniform, Slot::Read, Slot::Read, Slot::Uniform, Slot::Write, Slot::Read, Slot::Read];
        let [find] = kernels(gpu, find, &slots, ["main"]);
        let module = gpu.module(stroke);
        let stroke = RasterPipeline {
            label: "ink.strip",
            targets: &[INK_FORMAT],
            depth: Some(layers::nearest_wins()),
            ..Default::default()
        };
        Self { find, stroke: stroke.build(&module) }
    }
}

impl Vector {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        Self {
            models: Pipelines::new(gpu, shader!("ink/edges"), shader!("ink/strip")),
            surfaces: Pipelines::new(gpu, shader!("ink/contours"), shader!("ink/contour_strip")),
        }
    }

    /// Draws into `ink` the lines that are seen in `layers` of the objects that `members` numbers. Answers with
    /// the depth of surfaces, and of the lines where those are nearer: other lines may cover them, or be
    /// covered.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        compact: &Compact,
        (layers, members): (&Layers, &[usize]),
        ink: &Transient,
    ) -> Transient {
        let depth = frame.texture("ink.depth", layers.size, DEPTH_FORMAT);
        let (from, to) = (layers.depth.texture(), depth.texture());
        frame.encoder.copy_texture_to_texture(from.as_image_copy(), to.as_image_copy(), from.size());
        for lines in subject.meshes.lines(members) {
            let pipelines = if lines.of_surface { &self.surfaces } else { &self.models };
            find(frame, subject, pipelines, compact, lines);
            let target = Target::colour(ink, None).with_depth(&depth, None);
            stroke(frame, subject, pipelines, (lines, layers), target);
        }
        depth
    }
}

/// Lists the candidates whose lines may be seen.
fn find(
    frame: &mut Frame<'_>,
    subject: Subject<'_>,
    pipelines: &Pipelines,
    compact: &Compact,
    lines: LineScene<'_>,
) {
    let meshes = subject.meshes;
    frame.compute(
        "ink.edges",
        &pipelines.find,
        &[
            subject.view.as_entire_binding(),
            lines.candidates.as_entire_binding(),
            meshes.vertices.as_entire_binding(),
            subject.pens.as_entire_binding(),
            lines.flags.as_entire_binding(),
            meshes.triangles.as_entire_binding(),
            meshes.parts.as_entire_binding(),
        ],
        workgroups(lines.count),
    );
    let listing = Listing { items: lines.count, mask: ALL_KINDS, quads: 1 };
    compact.record(frame, lines.flags, listing, lines.list);
}

fn stroke(
    frame: &mut Frame<'_>,
    subject: Subject<'_>,
    pipelines: &Pipelines,
    (lines, layers): (LineScene<'_>, &Layers),
    target: Target<'_>,
) {
    let meshes = subject.meshes;
    frame.raster(
        "ink.strip",
        &pipelines.stroke,
        target,
        &[
            subject.view.as_entire_binding(),
            lines.candidates.as_entire_binding(),
            meshes.vertices.as_entire_binding(),
            subject.pens.as_entire_binding(),
            lines.list.items.as_entire_binding(),
            meshes.triangles.as_entire_binding(),
            meshes.parts.as_entire_binding(),
            wgpu::BindingResource::TextureView(&layers.id),
            wgpu::BindingResource::TextureView(&layers.depth),
            subject.lights.as_entire_binding(),
        ],
        |pass| lines.list.draw(pass),
    );
}
