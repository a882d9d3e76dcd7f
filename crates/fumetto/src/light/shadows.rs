//! Hard shadows by nailboard shadow volumes in the stencil buffer.
//!
//! Counted where depth fails ("z-fail"), so that a camera inside a volume changes nothing. The two
//! polygons of a puff follow each other, back before front, and the counts saturate instead of
//! wrapping: a puff that does not shadow a pixel adds one and takes it away again, so that however many
//! volumes overlap, a shadowed pixel never falls back to zero.

use super::LightsUniform;
use crate::{
    gpu::{
        Compact, DrawList, Frame, Gpu, Listing, RasterPipeline, Slot, Target, Transient, kernels, shader,
        workgroups,
    },
    layers::Layers,
    shapes::puffs::{Atlas, Pyramid, Subject},
};

const STENCIL_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth24PlusStencil8;

/// A channel for each light: above one half where its light is kept away.
pub(crate) const SHADOW_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// Bit of a puff's flags. Also in `casters.wgsl`.
const CASTS: u32 = 1;

/// Polygons of a shadow volume: one front, one back.
pub(crate) const QUADS: u32 = 2;

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Shadows {
    casters: wgpu::ComputePipeline,
    flatten: wgpu::RenderPipeline,
    volume: wgpu::RenderPipeline,
    /// One for each channel.
    shadowed: [wgpu::RenderPipeline; 4],
    settle: wgpu::RenderPipeline,
}

/// What one frame's shadows are found with.
#[derive(Debug)]
pub(crate) struct Stencil<'a> {
    pub(crate) compact: &'a Compact,
    pub(crate) flags: &'a wgpu::Buffer,
    pub(crate) list: &'a DrawList,
    pub(crate) pyramid: &'a Pyramid,
    /// Pixels of the picture to one of the stencil's.
    pub(crate) step: u32,
    /// Texels of the stencil that the shadows' edges are smoothed over.
    pub(crate) settle: u32,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct CastingUniform {
    light: u32,
    step: f32,
    pad: [u32; 2],
}

impl Shadows {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots = [
            Slot::Uniform,
            Slot::Uniform,
            Slot::Uniform,
            Slot::Uniform,
            Slot::Read,
            Slot::Read,
            Slot::Read,
            Slot::Write,
        ];
        let [casters] = kernels(gpu, shader!("light/casters"), &slots, ["main"]);
        let device = &gpu.device;
        let module = |program| device.create_shader_module(program);
        let flatten = RasterPipeline {
            label: "light.flatten",
            depth: Some(stencil_state(true, wgpu::CompareFunction::Always, wgpu::StencilState::default())),
            ..Default::default()
        };
        let volume = RasterPipeline {
            label: "light.volume",
            depth: Some(stencil_state(false, wgpu::CompareFunction::Greater, counting())),
            ..Default::default()
        };
        let shadowed = module(shader!("light/shadowed"));
        let settle =
            RasterPipeline { label: "light.settle", targets: &[SHADOW_FORMAT], ..Default::default() };
        Self {
            casters,
            flatten: flatten.build(device, &module(shader!("light/flatten"))),
            volume: volume.build(device, &module(shader!("light/volume"))),
            settle: settle.build(device, &module(shader!("light/settle"))),
            shadowed: [
                wgpu::ColorWrites::RED,
                wgpu::ColorWrites::GREEN,
                wgpu::ColorWrites::BLUE,
                wgpu::ColorWrites::ALPHA,
            ]
            .map(|write_mask| {
                let marking = RasterPipeline {
                    label: "light.shadowed",
                    targets: &[SHADOW_FORMAT],
                    write_mask,
                    depth: Some(stencil_state(false, wgpu::CompareFunction::Always, not_zero())),
                    ..Default::default()
                };
                marking.build(device, &shadowed)
            }),
        }
    }

    /// Which lights are kept away from what `layers` show.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        lights: &LightsUniform,
        layers: &Layers,
        stencil: &Stencil<'_>,
    ) -> Transient {
        if lights.casting().next().is_none() {
            let nowhere = frame.texture("light.shadow", [1, 1], SHADOW_FORMAT);
            frame.clear("light.shadow", Target::colour(&nowhere, Some(wgpu::Color::TRANSPARENT)));
            return nowhere;
        }
        let size = layers.size.map(|pixels| pixels.div_ceil(stencil.step));
        let shadow = frame.texture("light.shadow", size, SHADOW_FORMAT);
        let depth = frame.texture("light.stencil", size, STENCIL_FORMAT);
        let step = frame.uniform("light.flatten.uniform", &[stencil.step, 0, 0, 0]);
        frame.fullscreen(
            "light.flatten",
            &self.flatten,
            Target::default().with_stencil(&depth, Some(0.0), Some(0)),
            &[step.as_entire_binding(), wgpu::BindingResource::TextureView(&layers.depth)],
        );
        let mut clear = Some(wgpu::Color::TRANSPARENT);
        for (light, channel) in lights.casting() {
            self.find_casters(frame, subject, light, stencil);
            let listing = Listing { items: subject.scene.count, mask: CASTS, quads: QUADS };
            stencil.compact.record(frame, stencil.flags, listing, stencil.list);
            let target = Target::default().with_stencil(&depth, None, Some(0));
            count(frame, &self.volume, subject, light, stencil, target);
            frame.fullscreen(
                "light.shadowed",
                &self.shadowed[channel],
                Target::colour(&shadow, clear.take()).with_stencil(&depth, None, None),
                &[],
            );
        }
        self.settle(frame, shadow, size, stencil.settle)
    }

    /// Smooths the shadows' edges over `radius` texels.
    fn settle(&self, frame: &mut Frame<'_>, shadow: Transient, size: [u32; 2], radius: u32) -> Transient {
        let mut shadow = shadow;
        for axis in [[1, 0], [0, 1]] {
            let to = frame.texture("light.shadow", size, SHADOW_FORMAT);
            let uniform = frame.uniform("light.settle.uniform", &[axis[0], axis[1], radius as i32, 0]);
            frame.fullscreen(
                "light.settle",
                &self.settle,
                Target::colour(&to, Some(wgpu::Color::TRANSPARENT)),
                &[uniform.as_entire_binding(), wgpu::BindingResource::TextureView(&shadow)],
            );
            shadow = to;
        }
        shadow
    }

    fn find_casters(&self, frame: &mut Frame<'_>, subject: Subject<'_>, light: u32, stencil: &Stencil<'_>) {
        let uniform = frame.uniform("light.casters.uniform", &[subject.scene.count, light, 0, 0]);
        frame.compute(
            "light.casters",
            &self.casters,
            &[
                subject.view.as_entire_binding(),
                uniform.as_entire_binding(),
                stencil.pyramid.uniform.as_entire_binding(),
                subject.lights.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                stencil.pyramid.nearness.as_entire_binding(),
                stencil.flags.as_entire_binding(),
            ],
            workgroups(subject.scene.count),
        );
    }
}

/// Counts the volumes of the listed puffs.
fn count(
    frame: &mut Frame<'_>,
    volume: &wgpu::RenderPipeline,
    subject: Subject<'_>,
    light: u32,
    stencil: &Stencil<'_>,
    target: Target<'_>,
) {
    let casting = CastingUniform { light, step: stencil.step as f32, pad: [0; 2] };
    let casting = frame.uniform("light.volume.uniform", &casting);
    let Atlas { view: texture, uniform: atlas, .. } = &subject.scene.atlas;
    frame.raster(
        "light.volume",
        volume,
        target,
        &[
            subject.view.as_entire_binding(),
            atlas.as_entire_binding(),
            casting.as_entire_binding(),
            subject.lights.as_entire_binding(),
            subject.scene.puffs.as_entire_binding(),
            stencil.list.items.as_entire_binding(),
            subject.scene.styles.as_entire_binding(),
            wgpu::BindingResource::TextureView(texture),
        ],
        |pass| stencil.list.draw(pass),
    );
}

fn stencil_state(
    write: bool,
    compare: wgpu::CompareFunction,
    stencil: wgpu::StencilState,
) -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format: STENCIL_FORMAT,
        depth_write_enabled: Some(write),
        depth_compare: Some(compare),
        stencil,
        bias: wgpu::DepthBiasState::default(),
    }
}

/// Adds where a back polygon lies behind what is seen, subtracts where a front polygon does.
fn counting() -> wgpu::StencilState {
    let face = |depth_fail_op| wgpu::StencilFaceState {
        compare: wgpu::CompareFunction::Always,
        fail_op: wgpu::StencilOperation::Keep,
        depth_fail_op,
        pass_op: wgpu::StencilOperation::Keep,
    };
    wgpu::StencilState {
        front: face(wgpu::StencilOperation::DecrementClamp),
        back: face(wgpu::StencilOperation::IncrementClamp),
        read_mask: 0xff,
        write_mask: 0xff,
    }
}

/// Passes where something was counted.
fn not_zero() -> wgpu::StencilState {
    let face = wgpu::StencilFaceState { compare: wgpu::CompareFunction::NotEqual, ..Default::default() };
    wgpu::StencilState { front: face, back: face, read_mask: 0xff, write_mask: 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: CastingUniform, "Casting" of "light/volume" { light, step });
}
