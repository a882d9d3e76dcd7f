//! The form of each cloud, as a field of outward directions.

use super::scene::PuffScene;
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups};

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Form {
    measure: ComputePipeline,
    splat: ComputePipeline,
    blur: [ComputePipeline; 3],
    gradient: ComputePipeline,
}

/// The fields of all objects of a scene.
#[derive(Debug)]
pub(crate) struct FormField {
    /// Cells along each side of one object's grid.
    pub(crate) side: u32,
    /// Objects, one above the other along z.
    pub(crate) objects: u32,
    /// Where each object's grid lies: `FormGrid` of `form.wgsl`.
    pub(crate) grids: wgpu::Buffer,
    pub(crate) view: wgpu::TextureView,
    matter: wgpu::Buffer,
    blurred: [wgpu::Buffer; 2],
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct ObjectUniform {
    first: u32,
    count: u32,
    index: u32,
    side: u32,
}

/// Bytes of a `FormGrid`.
const GRID_BYTES: u64 = 64;

impl FormField {
    pub(crate) fn new(gpu: &Gpu, objects: u32) -> Self {
        // All grids together stay within a 3-D texture of 2048 cells and a few dozen megabytes.
        let side = if objects <= 16 { 40 } else { 32 };
        let cells = u64::from(side).pow(3) * u64::from(objects);
        let buffer = |label, size, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage: wgpu::BufferUsages::STORAGE | usage,
                mapped_at_creation: false,
            })
        };
        let none = wgpu::BufferUsages::empty();
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("shapes.puffs.form"),
            size: wgpu::Extent3d { width: side, height: side, depth_or_array_layers: side * objects },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D3,
            format: wgpu::TextureFormat::Rgba16Float,
            usage: wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        Self {
            side,
            objects,
            grids: buffer("shapes.puffs.form.grids", GRID_BYTES * u64::from(objects), none),
            view: texture.create_view(&wgpu::TextureViewDescriptor::default()),
            matter: buffer("shapes.puffs.form.matter", cells * 4, wgpu::BufferUsages::COPY_DST),
            blurred: [(); 2].map(|()| buffer("shapes.puffs.form.blurred", cells * 4, none)),
        }
    }
}

impl Form {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots = [
            Slot::Uniform,
            Slot::Read,
            Slot::Uniform,
            Slot::Write,
            Slot::Write,
            Slot::Read,
            Slot::Write,
            Slot::WriteTexture3d,
        ];
        let entries = ["measure", "splat", "blur_x", "blur_y", "blur_z", "gradient"];
        let [measure, splat, blur_x, blur_y, blur_z, gradient] =
            kernels(gpu, shader!("shapes/puffs/form"), &slots, entries);
        Self { measure, splat, blur: [blur_x, blur_y, blur_z], gradient }
    }

    /// Works out the fields of those members of a cel whose form is wanted.
    pub(crate) fn record(&self, frame: &mut Frame<'_>, scene: &PuffScene, members: &[usize]) {
        frame.encoder.clear_buffer(&scene.form.matter, 0, None);
        for &member in members {
            // Surfaces inside others have no puffs of their own.
            if scene.objects.get(member).is_some_and(|object| object.wants_form) {
                self.record_object(frame, scene, member);
            }
        }
    }

    fn record_object(&self, frame: &mut Frame<'_>, scene: &PuffScene, member: usize) {
        let field = &scene.form;
        let range = &scene.objects[member].range;
        let count = range.len() as u32;
        let object = ObjectUniform { first: range.start, count, index: member as u32, side: field.side };
        let object = frame.uniform("shapes.puffs.form.object", &object);
        let groups = [field.side.div_ceil(8), field.side.div_ceil(8), field.side.div_ceil(4)];
        let steps = [
            (&self.measure, [1, 1, 1]),
            (&self.splat, workgroups(count)),
            (&self.blur[0], groups),
            (&self.blur[1], groups),
            (&self.blur[2], groups),
            (&self.gradient, groups),
        ];
        for (step, (pipeline, groups)) in steps.into_iter().enumerate() {
            // Blurs go back and forth between the two buffers.
            let [from, to] = [&field.blurred[(step + 1) % 2], &field.blurred[step % 2]];
            frame.compute(
                "shapes.puffs.form",
                pipeline,
                &[
                    object.as_entire_binding(),
                    scene.puffs.as_entire_binding(),
                    scene.styles.as_entire_binding(),
                    field.grids.as_entire_binding(),
                    field.matter.as_entire_binding(),
                    from.as_entire_binding(),
                    to.as_entire_binding(),
                    wgpu::BindingResource::TextureView(&field.view),
                ],
                groups,
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: ObjectUniform, "Object" of "shapes/puffs/form" { first, count, index, side });
}
