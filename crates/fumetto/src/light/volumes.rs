//! Hard shadows of meshes by shadow volumes, counted where they lie behind what is seen ("z-fail").
//!
//! The count at a pixel is how many triangles keep the light from it. It is made of ones that are added and
//! taken away in a texture of half floats, which are exact up to 2048 whatever the order; what a stencil
//! would do as well, but `WebGPU`'s only stencil that every device has comes with a depth of 24 bits, and
//! then a cap would no longer lie exactly on the triangle that throws it. Here the layers' own depth is
//! tested.

use wgpu::util::DeviceExt as _;

use super::{LightsUniform, shadows::SHADOW_FORMAT};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Slot, Target, Transient, kernels, linear_sampler, shader, workgroups},
    layers::{DEPTH_FORMAT, Layers},
    shapes::{mesh::Casters, puffs::Subject},
};

const COUNT_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R16Float;

/// Units of the last place by which caps are moved away from their triangles, so that a triangle never
/// shadows itself, nor the back of a sheet of paper its front. Rasterisers round depth by less.
const CAP_BIAS: i32 = 16;

/// Bytes of an indirect draw's arguments.
const DRAW_BYTES: u64 = 16;

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Volumes {
    list_caps: wgpu::ComputePipeline,
    list_sides: wgpu::ComputePipeline,
    /// Caps whose lit side is seen, and the others.
    caps: [wgpu::RenderPipeline; 2],
    far_caps: wgpu::RenderPipeline,
    sides: wgpu::RenderPipeline,
    counted: wgpu::RenderPipeline,
    linear: wgpu::Sampler,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct VolumesUniform {
    light: u32,
    triangles: u32,
    edges: u32,
    side_vertices: u32,
}

/// One light's volumes.
struct Extruded<'a> {
    casters: &'a Casters,
    uniform: wgpu::Buffer,
    /// Arguments of three draws: of the caps whose lit side is seen, of the others, of the sides.
    draws: wgpu::Buffer,
}

impl Volumes {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        use Slot::{Read, Uniform, Write};
        let slots = [Uniform, Uniform, Uniform, Read, Read, Read, Read, Write, Write, Write, Write];
        let [list_caps, list_sides] =
            kernels(gpu, shader!("light/extrude"), &slots, ["list_caps", "list_sides"]);
        let module = |program| gpu.device.create_shader_module(program);
        let cap = module(shader!("light/cap"));
        let caps = |is_far, behind, bias| face("light.cap", is_far, behind, bias).build(&gpu.device, &cap);
        let counted =
            RasterPipeline { label: "light.counted", targets: &[SHADOW_FORMAT], ..Default::default() };
        Self {
            list_caps,
            list_sides,
            // Where a cap is what is seen, its light is kept away neither from its lit side, for which it counts
            // as behind itself, nor from the other, which is dark anyway.
            caps: [
                caps(&[("IS_FAR", 0.0)], wgpu::CompareFunction::LessEqual, -CAP_BIAS),
                caps(&[("IS_FAR", 0.0)], wgpu::CompareFunction::Less, CAP_BIAS),
            ],
            far_caps: caps(&[("IS_FAR", 1.0)], wgpu::CompareFunction::Less, 0),
            sides: face("light.side", &[], wgpu::CompareFunction::Less, 0)
                .build(&gpu.device, &module(shader!("light/side"))),
            counted: counted.build(&gpu.device, &module(shader!("light/counted"))),
            linear: linear_sampler(gpu),
        }
    }

    /// Adds to `shadow` which lights meshes keep away from what `layers` show.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        lights: &LightsUniform,
        layers: &Layers,
        shadow: Transient,
    ) -> Transient {
        let Some(casters) = &subject.meshes.casters else { return shadow };
        let mut shadow = shadow;
        for (light, channel) in lights.casting() {
            let volumes = self.extrude(frame, subject, casters, light, lights.is_point(light));
            let counts = frame.texture("light.counts", layers.size, COUNT_FORMAT);
            self.count(frame, subject, &volumes, layers, &counts, lights.is_point(light));
            shadow = self.add(frame, casters, layers, (&counts, channel), &shadow);
        }
        shadow
    }

    /// Lists the faces of one light's volumes.
    fn extrude<'a>(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        casters: &'a Casters,
        light: u32,
        is_point: bool,
    ) -> Extruded<'a> {
        let (triangles, edges) = (casters.triangle_count, casters.edge_count);
        let uniform = VolumesUniform { light, triangles, edges, side_vertices: if is_point { 6 } else { 3 } };
        let uniform = frame.uniform("light.volumes.uniform", &uniform);
        let draws = frame.gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("light.volumes.draws"),
            contents: bytemuck::cast_slice(&[[0, 1, 0, 0], [0, 1, 3 * triangles, 0], [0, 1, 0, 0]]),
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::INDIRECT,
        });
        let bindings = [
            subject.view.as_entire_binding(),
            subject.lights.as_entire_binding(),
            uniform.as_entire_binding(),
            subject.meshes.vertices.as_entire_binding(),
            subject.meshes.triangles.as_entire_binding(),
            casters.casting.as_entire_binding(),
            casters.edges.as_entire_binding(),
            casters.facings.as_entire_binding(),
            casters.caps.as_entire_binding(),
            casters.sides.as_entire_binding(),
            draws.as_entire_binding(),
        ];
        frame.compute("light.extrude.caps", &self.list_caps, &bindings, workgroups(triangles));
        frame.compute("light.extrude.sides", &self.list_sides, &bindings, workgroups(edges));
        Extruded { casters, uniform, draws }
    }

    /// Counts how many volumes each pixel lies in.
    fn count(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        volumes: &Extruded<'_>,
        layers: &Layers,
        counts: &Transient,
        is_point: bool,
    ) {
        let Extruded { casters, uniform, draws } = volumes;
        let meshes = subject.meshes;
        let mut clear = Some(wgpu::Color::TRANSPARENT);
        let mut draw = |pipeline, list: [&wgpu::Buffer; 2], number: u64| {
            frame.raster(
                "light.volumes",
                pipeline,
                Target::colour(counts, clear.take()).with_depth_test(&layers.depth),
                &[
                    subject.view.as_entire_binding(),
                    subject.lights.as_entire_binding(),
                    uniform.as_entire_binding(),
                    meshes.vertices.as_entire_binding(),
                    list[0].as_entire_binding(),
                    list[1].as_entire_binding(),
                ],
                |pass| pass.draw_indirect(draws, number * DRAW_BYTES),
            );
        };
        let caps = [&meshes.triangles, &casters.caps];
        for (number, pipeline) in (0..).zip(&self.caps) {
            draw(pipeline, caps, number);
            // A sun's volumes end in a point.
            if is_point {
                draw(&self.far_caps, caps, number);
            }
        }
        draw(&self.sides, [&casters.edges, &casters.sides], 2);
    }

    /// `shadow` and what was counted, as large as the layers.
    fn add(
        &self,
        frame: &mut Frame<'_>,
        casters: &Casters,
        layers: &Layers,
        (counts, channel): (&Transient, usize),
        shadow: &Transient,
    ) -> Transient {
        let sum = frame.texture("light.shadow", layers.size, SHADOW_FORMAT);
        let channels = [0, 1, 2, 3].map(|other| f32::from(u8::from(other == channel)));
        let uniform = frame.uniform("light.counted.uniform", &channels);
        frame.fullscreen(
            "light.counted",
            &self.counted,
            Target::colour(&sum, Some(wgpu::Color::TRANSPARENT)),
            &[
                uniform.as_entire_binding(),
                wgpu::BindingResource::TextureView(counts),
                wgpu::BindingResource::TextureView(shadow),
                wgpu::BindingResource::Sampler(&self.linear),
                wgpu::BindingResource::TextureView(&layers.id),
                casters.facings.as_entire_binding(),
            ],
        );
        sum
    }
}

/// Faces that count where they lie `behind` what is seen.
fn face<'a>(
    label: &'a str,
    constants: &'a [(&'a str, f64)],
    behind: wgpu::CompareFunction,
    bias: i32,
) -> RasterPipeline<'a> {
    let add = wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::One,
        dst_factor: wgpu::BlendFactor::One,
        operation: wgpu::BlendOperation::Add,
    };
    RasterPipeline {
        label,
        targets: &[COUNT_FORMAT],
        depth: Some(wgpu::DepthStencilState {
            format: DEPTH_FORMAT,
            depth_write_enabled: Some(false),
            depth_compare: Some(behind),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState { constant: bias, ..Default::default() },
        }),
        blend: Some(wgpu::BlendState { color: add, alpha: add }),
        constants,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: VolumesUniform, "Volumes" of "light/cap" { light, triangles, edges, side_vertices });
}
