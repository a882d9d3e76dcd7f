use wgpu::util::DeviceExt as _;

use super::{Gpu, Module, RenderPipeline, TexturePool, Transient};

/// What is being recorded: one encoder, and where passes find their transient textures.
pub(crate) struct Frame<'a> {
    pub(crate) gpu: &'a Gpu,
    pub(crate) pool: &'a TexturePool,
    pub(crate) encoder: wgpu::CommandEncoder,
}

/// What a raster pass draws into.
#[derive(Default)]
pub(crate) struct Target<'a> {
    /// Colour attachments with what they are cleared to; `None` keeps what is there.
    pub(crate) colours: Vec<(&'a wgpu::TextureView, Option<wgpu::Color>)>,
    /// Depth.
    pub(crate) depth: Option<wgpu::RenderPassDepthStencilAttachment<'a>>,
}

impl<'a> Target<'a> {
    /// One colour attachment.
    pub(crate) fn colour(view: &'a wgpu::TextureView, clear: Option<wgpu::Color>) -> Self {
        Self { colours: vec![(view, clear)], depth: None }
    }

    /// Adds a depth attachment; `clear` as for colours.
    pub(crate) fn with_depth(mut self, view: &'a wgpu::TextureView, clear: Option<f32>) -> Self {
        let load = clear.map_or(wgpu::LoadOp::Load, wgpu::LoadOp::Clear);
        self.depth = Some(wgpu::RenderPassDepthStencilAttachment {
            view,
            depth_ops: Some(wgpu::Operations { load, store: wgpu::StoreOp::Store }),
            stencil_ops: None,
        });
        self
    }

    /// Adds a depth attachment that is tested but not written, so that shaders may read it too.
    pub(crate) fn with_depth_test(mut self, view: &'a wgpu::TextureView) -> Self {
        self.depth =
            Some(wgpu::RenderPassDepthStencilAttachment { view, depth_ops: None, stencil_ops: None });
        self
    }
}

impl<'a> Frame<'a> {
    pub(crate) fn new(gpu: &'a Gpu, pool: &'a TexturePool, label: &str) -> Self {
        let encoder =
            gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some(label) });
        Self { gpu, pool, encoder }
    }

    /// Hands what was recorded to the queue.
    pub(crate) fn submit(self) {
        self.gpu.queue.submit([self.encoder.finish()]);
    }

    /// Hands what was recorded to the queue and begins anew: what is written into buffers between two frames comes
    /// between them.
    pub(crate) fn flush(&mut self, label: &str) {
        let next = Self::new(self.gpu, self.pool, label);
        std::mem::replace(self, next).submit();
    }

    /// A uniform buffer that lives for this frame.
    pub(crate) fn uniform<T: bytemuck::Pod>(&self, label: &str, value: &T) -> wgpu::Buffer {
        self.gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some(label),
            contents: bytemuck::bytes_of(value),
            usage: wgpu::BufferUsages::UNIFORM,
        })
    }

    /// A read-only storage buffer that lives for this frame; a list of nothing still has one item's room.
    pub(crate) fn storage<T: bytemuck::Pod>(&self, label: &str, items: &[T]) -> wgpu::Buffer {
        let nothing = [T::zeroed()];
        let items = if items.is_empty() { &nothing } else { items };
        self.gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some(label),
            contents: bytemuck::cast_slice(items),
            usage: wgpu::BufferUsages::STORAGE,
        })
    }

    /// A storage buffer of zeros that lives for this frame.
    pub(crate) fn zeros(&self, label: &str, words: u32) -> wgpu::Buffer {
        self.gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: u64::from(words.max(1)) * 4,
            usage: wgpu::BufferUsages::STORAGE,
            mapped_at_creation: false,
        })
    }

    /// A texture that goes back to the pool when it is dropped.
    pub(crate) fn texture(
        &self,
        label: &'static str,
        size: [u32; 2],
        format: wgpu::TextureFormat,
    ) -> Transient {
        self.pool.take(&self.gpu.device, label, [size[0], size[1], 1], format)
    }

    /// Runs a kernel. Bindings are numbered from 0 in the order given.
    pub(crate) fn compute(
        &mut self,
        label: &str,
        pipeline: &wgpu::ComputePipeline,
        bindings: &[wgpu::BindingResource<'_>],
        groups: [u32; 3],
    ) {
        let mut pass = self.begin_compute(label, pipeline, bindings);
        pass.dispatch_workgroups(groups[0], groups[1], groups[2]);
    }

    /// Runs a kernel with as many workgroups as the buffer `groups` says.
    pub(crate) fn compute_indirect(
        &mut self,
        label: &str,
        pipeline: &wgpu::ComputePipeline,
        bindings: &[wgpu::BindingResource<'_>],
        groups: &wgpu::Buffer,
    ) {
        self.begin_compute(label, pipeline, bindings).dispatch_workgroups_indirect(groups, 0);
    }

    fn begin_compute(
        &mut self,
        label: &str,
        pipeline: &wgpu::ComputePipeline,
        bindings: &[wgpu::BindingResource<'_>],
    ) -> wgpu::ComputePass<'_> {
        let group = bind(&self.gpu.device, label, &pipeline.get_bind_group_layout(0), bindings);
        let mut pass = self
            .encoder
            .begin_compute_pass(&wgpu::ComputePassDescriptor { label: Some(label), timestamp_writes: None });
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass
    }

    /// Clears a target and draws nothing.
    pub(crate) fn clear(&mut self, label: &str, target: Target<'_>) {
        drop(begin(&mut self.encoder, label, target));
    }

    /// Draws. Bindings are numbered from 0 in the order given.
    pub(crate) fn raster(
        &mut self,
        label: &str,
        pipeline: &wgpu::RenderPipeline,
        target: Target<'_>,
        bindings: &[wgpu::BindingResource<'_>],
        draw: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) {
        let group = bind(&self.gpu.device, label, &pipeline.get_bind_group_layout(0), bindings);
        let mut pass = begin(&mut self.encoder, label, target);
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &group, &[]);
        draw(&mut pass);
    }

    /// Draws one triangle that covers the whole target.
    pub(crate) fn fullscreen(
        &mut self,
        label: &str,
        pipeline: &wgpu::RenderPipeline,
        target: Target<'_>,
        bindings: &[wgpu::BindingResource<'_>],
    ) {
        self.raster(label, pipeline, target, bindings, |pass| pass.draw(0..3, 0..1));
    }
}

fn begin<'e>(encoder: &'e mut wgpu::CommandEncoder, label: &str, target: Target<'_>) -> wgpu::RenderPass<'e> {
    let colours: Vec<_> = target
        .colours
        .iter()
        .map(|&(view, clear)| {
            let load = clear.map_or(wgpu::LoadOp::Load, wgpu::LoadOp::Clear);
            let ops = wgpu::Operations { load, store: wgpu::StoreOp::Store };
            Some(wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops })
        })
        .collect();
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &colours,
        depth_stencil_attachment: target.depth,
        ..Default::default()
    })
}

fn bind(
    device: &wgpu::Device,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    bindings: &[wgpu::BindingResource<'_>],
) -> wgpu::BindGroup {
    let entries: Vec<_> = (0..)
        .zip(bindings)
        .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource: resource.clone() })
        .collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
}

/// How a raster pipeline differs from the plainest one.
#[derive(Clone, Debug, Default)]
pub(crate) struct RasterPipeline<'a> {
    pub(crate) label: &'static str,
    pub(crate) targets: &'a [wgpu::TextureFormat],
    pub(crate) depth: Option<wgpu::DepthStencilState>,
    /// What is done with what the targets hold; `None` replaces it.
    pub(crate) blend: Option<wgpu::BlendState>,
    /// Values of the shaders' `override` constants.
    pub(crate) constants: &'a [(&'static str, f64)],
}

impl RasterPipeline<'_> {
    /// The pipeline of a module's `vertex` and `fragment`.
    pub(crate) fn build(self, module: &Module) -> RenderPipeline {
        let Self { label, targets, depth, blend, constants } = self;
        let state =
            |&format| Some(wgpu::ColorTargetState { format, blend, write_mask: wgpu::ColorWrites::ALL });
        let targets: Vec<_> = targets.iter().map(state).collect();
        let constants = constants.to_vec();
        module.later(move |device, module| {
            let compilation_options =
                wgpu::PipelineCompilationOptions { constants: &constants, ..Default::default() };
            device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(label),
                layout: None,
                vertex: wgpu::VertexState {
                    module,
                    entry_point: Some("vertex"),
                    compilation_options: compilation_options.clone(),
                    buffers: &[],
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: depth,
                multisample: wgpu::MultisampleState::default(),
                fragment: Some(wgpu::FragmentState {
                    module,
                    entry_point: Some("fragment"),
                    compilation_options,
                    targets: &targets,
                }),
                multiview_mask: None,
                cache: None,
            })
        })
    }
}
