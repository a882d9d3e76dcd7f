//! What differs where the density is that of a file's bricks, and not of particles.
//!
//! Balls that cover the bricks stand for them until it is known where the lattice lies. From there on the file itself is
//! asked: which blocks its surface may cross, which points are inside, and where it crosses lattice edges.

use super::{Job, noisy::Noisy};
use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, linear_sampler, shader, workgroups},
    shapes::{mesh::Reserved, volume::BrickField},
};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Bricks {
    classify: ComputePipeline,
    signs: Noisy,
    vertices: Noisy,
    linear: wgpu::Sampler,
}

impl Bricks {
    pub(super) fn new(gpu: &Gpu) -> Self {
        use Slot::{Linear, Read, Texture3d, Uniform, Write};
        let with = |own: &[Slot]| [&[Uniform, Read, Linear, Read, Read, Texture3d], own].concat();
        let slots = with(&[Read, Read, Write, Write]);
        let [classify] = kernels(gpu, shader!("shapes/surface/bricks/blocks"), &slots, ["main"]);
        let signs = Noisy::new(gpu, &shader!("shapes/surface/bricks/signs"), &with(&[Read, Write]));
        let slots = with(&[Read, Read, Read, Write]);
        let vertices = Noisy::new(gpu, &shader!("shapes/surface/bricks/vertices"), &slots);
        Self { classify, signs, vertices, linear: linear_sampler(gpu) }
    }

    /// Tells of each block whether the surface may cross it.
    pub(super) fn classify(&self, frame: &mut Frame<'_>, job: Job<'_>, field: &BrickField) {
        let Job { room, work, .. } = job;
        let own = [&field.extremes, &work.kept, &work.states, &work.crossed];
        let atlas = view(field);
        let bindings = self.bindings(job, (field, &atlas), own.map(wgpu::Buffer::as_entire_binding));
        frame.compute("shapes.surface.bricks.classify", &self.classify, &bindings, workgroups(room.blocks));
    }

    /// Samples the active blocks.
    pub(super) fn signs(&self, frame: &mut Frame<'_>, job: Job<'_>, field: &BrickField) {
        let Job { noisy, work, .. } = job;
        let own = [&work.active, &work.signs].map(wgpu::Buffer::as_entire_binding);
        let atlas = view(field);
        let bindings = self.bindings(job, (field, &atlas), own);
        let kernel = self.signs.get(noisy);
        frame.compute_indirect("shapes.surface.bricks.signs", kernel, &bindings, &work.dispatch);
    }

    /// Writes the vertices.
    pub(super) fn vertices(&self, frame: &mut Frame<'_>, job: Job<'_>, field: &BrickField, mesh: &Reserved) {
        let Job { noisy, work, .. } = job;
        let own = [&work.active, &work.crossings, &work.mesh_starts].map(wgpu::Buffer::as_entire_binding);
        let atlas = view(field);
        let bindings = self.bindings(job, (field, &atlas), own.into_iter().chain([mesh.vertices()]));
        let kernel = self.vertices.get(noisy);
        frame.compute_indirect("shapes.surface.bricks.vertices", kernel, &bindings, &work.chunks);
    }

    /// Those that all kernels share, and a kernel's own.
    fn bindings<'a>(
        &'a self,
        job: Job<'a>,
        (field, atlas): (&'a BrickField, &'a wgpu::TextureView),
        own: impl IntoIterator<Item = wgpu::BindingResource<'a>>,
    ) -> Vec<wgpu::BindingResource<'a>> {
        let mut bindings = vec![
            job.recipe.as_entire_binding(),
            job.work.lattice.as_entire_binding(),
            wgpu::BindingResource::Sampler(&self.linear),
            field.grid.as_entire_binding(),
            field.table.as_entire_binding(),
            wgpu::BindingResource::TextureView(atlas),
        ];
        bindings.extend(own);
        bindings
    }
}

fn view(field: &BrickField) -> wgpu::TextureView {
    field.atlas.create_view(&wgpu::TextureViewDescriptor::default())
}
