//! Compute pipelines of one program that share their bindings.

use super::{ComputePipeline, Gpu};

/// What is bound to one number.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Slot {
    Uniform,
    /// A storage buffer that is only read.
    Read,
    /// A storage buffer that is written too.
    Write,
    /// A 3-D texture of half floats that is written.
    WriteTexture3d,
    /// A 3-D texture of whole numbers that is written.
    WriteIds3d,
    /// A texture of such texels that is written.
    WriteTexels(wgpu::TextureFormat),
    /// A texture of such texels that is read with no sampler.
    ReadTexels(wgpu::TextureFormat),
    /// A texture of whole numbers that is read.
    Ids,
    /// A depth texture that is read.
    Depth,
    /// A 3-D texture of floats that is read.
    Texture3d,
    /// A sampler that does not filter.
    Nearest,
    /// A sampler that does.
    Linear,
}

impl Slot {
    fn binding_type(self) -> wgpu::BindingType {
        let buffer = |ty| wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
        let texture = |sample_type, view_dimension| wgpu::BindingType::Texture {
            sample_type,
            view_dimension,
            multisampled: false,
        };
        let texels = |access, format, view_dimension| wgpu::BindingType::StorageTexture {
            access,
            format,
            view_dimension,
        };
        let written =
            |format, view_dimension| texels(wgpu::StorageTextureAccess::WriteOnly, format, view_dimension);
        let floats = wgpu::TextureSampleType::Float { filterable: true };
        match self {
            Self::Uniform => buffer(wgpu::BufferBindingType::Uniform),
            Self::Read => buffer(wgpu::BufferBindingType::Storage { read_only: true }),
            Self::Write => buffer(wgpu::BufferBindingType::Storage { read_only: false }),
            Self::Depth => texture(wgpu::TextureSampleType::Depth, wgpu::TextureViewDimension::D2),
            Self::Nearest => wgpu::BindingType::Sampler(wgpu::SamplerBindingType::NonFiltering),
            Self::Linear => wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
            Self::Texture3d => texture(floats, wgpu::TextureViewDimension::D3),
            Self::WriteTexture3d => written(wgpu::TextureFormat::Rgba16Float, wgpu::TextureViewDimension::D3),
            Self::WriteIds3d => written(wgpu::TextureFormat::R32Uint, wgpu::TextureViewDimension::D3),
            Self::WriteTexels(format) => written(format, wgpu::TextureViewDimension::D2),
            Self::Ids => texture(wgpu::TextureSampleType::Uint, wgpu::TextureViewDimension::D2),
            Self::ReadTexels(format) => {
                texels(wgpu::StorageTextureAccess::ReadOnly, format, wgpu::TextureViewDimension::D2)
            }
        }
    }
}

/// One pipeline for each of `entries`; slots are numbered from 0.
///
/// All share one layout, though not every entry uses every slot, so that one list of bindings serves
/// them all.
pub(crate) fn kernels<const N: usize>(
    gpu: &Gpu,
    program: wgpu::ShaderModuleDescriptor<'static>,
    slots: &[Slot],
    entries: [&'static str; N],
) -> [ComputePipeline; N] {
    kernels_with(gpu, program, slots, entries, &[])
}

/// Likewise, with values of the program's `override` constants.
pub(crate) fn kernels_with<const N: usize>(
    gpu: &Gpu,
    program: wgpu::ShaderModuleDescriptor<'static>,
    slots: &[Slot],
    entries: [&'static str; N],
    constants: &[(&'static str, f64)],
) -> [ComputePipeline; N] {
    let label = program.label;
    let module = gpu.module(program);
    let slots: Vec<_> = (0..)
        .zip(slots)
        .map(|(binding, slot)| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: slot.binding_type(),
            count: None,
        })
        .collect();
    let group =
        gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label, entries: &slots });
    let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label,
        bind_group_layouts: &[Some(&group)],
        immediate_size: 0,
    });
    entries.map(|entry| {
        let (layout, constants) = (layout.clone(), constants.to_vec());
        module.later(move |device, module| {
            device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label,
                layout: Some(&layout),
                module,
                entry_point: Some(entry),
                compilation_options: wgpu::PipelineCompilationOptions {
                    constants: &constants,
                    ..Default::default()
                },
                cache: None,
            })
        })
    })
}
