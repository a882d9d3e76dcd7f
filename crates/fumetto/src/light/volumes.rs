//! Hard shadows of meshes and surfaces by shadow volumes, counted where they lie behind what is seen ("z-fail").
//!
//! The count at a pixel is how many triangles keep the light from it. It is made of ones that are added and
//! taken away in a texture of half floats, which are exact up to 2048 whatever the order; what a stencil
//! would do as well, but `WebGPU`'s only stencil that every device has comes with a depth of 24 bits, and
//! then a cap would no longer lie exactly on the triangle that throws it. Here the layers' own depth is
//! tested.

use super::{
    LightsUniform,
    extrude::{Extrude, Extruded},
    shadows::SHADOW_FORMAT,
};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, linear_sampler, shader},
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
    extrude: Extrude,
    /// Caps whose lit side is seen, and the others.
    caps: [RenderPipeline; 2],
    far_caps: RenderPipeline,
    sides: RenderPipeline,
    counted: RenderPipeline,
    linear: wgpu::Sampler,
}

impl Volumes {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = |program| gpu.module(program);
        let cap = module(shader!("light/cap"));
        let caps = |is_far, behind, bias| face("light.cap", is_far, behind, bias).build(&cap);
        let counted =
            RasterPipeline { label: "light.counted", targets: &[SHADOW_FORMAT], ..Default::default() };
        Self {
            extrude: Extrude::new(gpu),
            // Where a cap is what is seen, its light is kept away neither from its lit side, for which it counts
            // as behind itself, nor from the other, which is dark anyway.
            caps: [
                caps(&[("IS_FAR", 0.0)], wgpu::CompareFunction::LessEqual, -CAP_BIAS),
                caps(&[("IS_FAR", 0.0)], wgpu::CompareFunction::Less, CAP_BIAS),
            ],
            far_caps: caps(&[("IS_FAR", 1.0)], wgpu::CompareFunction::Less, 0),
            sides: face("light.side", &[], wgpu::CompareFunction::Less, 0)
                .build(&module(shader!("light/side"))),
            counted: counted.build(&module(shader!("light/counted"))),
            linear: linear_sampler(gpu),
        }
    }

    /// Adds to `shadow` which lights triangles keep away from what `layers` show.
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
            let volumes = self.extrude.record(frame, subject, casters, light, lights.is_point(light));
            let counts = frame.texture("light.counts", layers.size, COUNT_FORMAT);
            self.count(frame, subject, &volumes, layers, &counts, lights.is_point(light));
            shadow = self.add(frame, casters, layers, (&counts, channel), &shadow);
        }
        shadow
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
        let mut draw = |pipeline, lists: &[&wgpu::Buffer], number: u64| {
            let bindings = [subject.view, subject.lights, uniform, &meshes.vertices];
            let bindings: Vec<_> =
                bindings.iter().chain(lists).map(|buffer| buffer.as_entire_binding()).collect();
            frame.raster(
                "light.volumes",
                pipeline,
                Target::colour(counts, clear.take()).with_depth_test(&layers.depth),
                &bindings,
                |pass| pass.draw_indirect(draws, number * DRAW_BYTES),
            );
        };
        let caps = [&meshes.triangles, &casters.caps];
        for (number, pipeline) in (0..).zip(&self.caps) {
            draw(pipeline, &caps, number);
            // A sun's volumes end in a point.
            if is_point {
                draw(&self.far_caps, &caps, number);
            }
        }
        draw(&self.sides, &[&casters.sides], 2);
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
    label: &'static str,
    constants: &'a [(&'static str, f64)],
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
