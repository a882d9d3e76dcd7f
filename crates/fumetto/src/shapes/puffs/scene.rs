use std::ops::Range;

use super::{atlas::Atlas, form::FormField, present::Puff};
use crate::{gpu::Gpu, object::MAX_OBJECTS, shapes::mesh::MeshScene};

/// All puffs of a scene, and what they are drawn with.
#[derive(Debug)]
pub(crate) struct PuffScene {
    /// `Puff`s of `puff.wgsl`, object after object; those of radius zero are not there.
    pub(crate) puffs: wgpu::Buffer,
    pub(crate) count: u32,
    /// `ObjectStyle`s of `object.wgsl`, by the object's number.
    pub(crate) styles: wgpu::Buffer,
    pub(crate) atlas: Atlas,
    pub(crate) form: FormField,
    pub(crate) objects: Vec<PuffObject>,
}

/// What a cel is drawn of, from where, and in which light.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Subject<'a> {
    pub(crate) scene: &'a PuffScene,
    pub(crate) meshes: &'a MeshScene,
    /// `View` of `view.wgsl`.
    pub(crate) view: &'a wgpu::Buffer,
    /// `Lights` of `lights.wgsl`.
    pub(crate) lights: &'a wgpu::Buffer,
    /// `Pen`s of `pen.wgsl`.
    pub(crate) pens: &'a wgpu::Buffer,
}

/// One object's share of the puffs.
#[derive(Clone, Debug)]
pub(crate) struct PuffObject {
    pub(crate) range: Range<u32>,
    /// Whether its normals bend toward its form.
    pub(crate) wants_form: bool,
}

impl PuffScene {
    pub(crate) fn new(gpu: &Gpu, atlas: Atlas, objects: Vec<PuffObject>, style_bytes: u64) -> Self {
        let count = objects.last().map_or(0, |object| object.range.end);
        let buffer = |label, size: u64, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC | usage,
                mapped_at_creation: false,
            })
        };
        Self {
            puffs: buffer(
                "shapes.puffs",
                u64::from(count.max(1)) * size_of::<Puff>() as u64,
                wgpu::BufferUsages::STORAGE,
            ),
            count,
            styles: buffer(
                "shapes.puffs.styles",
                style_bytes * MAX_OBJECTS as u64,
                wgpu::BufferUsages::UNIFORM,
            ),
            atlas,
            form: FormField::new(gpu, objects.len().max(1) as u32),
            objects,
        }
    }
}
