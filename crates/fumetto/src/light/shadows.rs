//! Hard shadows by nailboard shadow volumes: a mask of what lies in any of them.
//!
//! A volume marks what is seen inside it. Marks are bits that only ever get set, so it does not matter in
//! which order, or how often.

use super::LightsUniform;
use crate::{
    gpu::{
        Compact, ComputePipeline, DrawList, Frame, Gpu, Listing, RasterPipeline, RenderPipeline, Slot,
        Target, Transient, kernels, shader, workgroups,
    },
    layers::Layers,
    shapes::puffs::{Atlas, HEIGHTS_SLOT, Pyramid, Reduce, Subject},
};

/// A channel for each light: above one half where its light is kept away.
pub(crate) const SHADOW_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// What each texel of the mask stands for.
const DEPTHS_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R32Float;

/// Bits of a puff's flags, and of a texel in the mask. Also in `casting.wgsl`.
const CASTS_SMALL: u32 = 1;
const CASTS_LARGE: u32 = 2;
const TEXEL_BITS: u32 = 4;

/// Workgroups that share the large volumes: enough to fill a GPU.
const TEAMS: u32 = 256;

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Shadows {
    casters: ComputePipeline,
    small: ComputePipeline,
    large: ComputePipeline,
    depths: RenderPipeline,
    shadowed: RenderPipeline,
    settle: RenderPipeline,
}

/// What one frame's shadows are found with.
#[derive(Debug)]
pub(crate) struct Casting<'a> {
    pub(crate) compact: &'a Compact,
    pub(crate) flags: &'a wgpu::Buffer,
    pub(crate) list: &'a DrawList,
    pub(crate) reduce: &'a Reduce,
    pub(crate) pyramid: &'a Pyramid,
    /// Pixels of the picture along a texel of the mask.
    pub(crate) step: u32,
    /// Texels that the shadows' edges are smoothed over.
    pub(crate) settle: u32,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct CastingUniform {
    count: u32,
    light: u32,
    channel: u32,
    step: f32,
    size: [u32; 2],
    pad: [u32; 2],
}

impl Shadows {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        use Slot::{Read, ReadTexels, Uniform, Write};
        let slots = [Uniform, Uniform, Uniform, Uniform, Read, Uniform, Read, Write];
        let [casters] = kernels(gpu, shader!("light/casters"), &slots, ["main"]);
        let depths = ReadTexels(DEPTHS_FORMAT);
        let slots =
            [Uniform, Uniform, Uniform, Uniform, Read, Read, Read, Uniform, HEIGHTS_SLOT, depths, Write];
        let [small, large] = kernels(gpu, shader!("light/cast"), &slots, ["small", "large"]);
        let raster = |label, program, format| {
            let module = gpu.module(program);
            RasterPipeline { label, targets: &[format], ..Default::default() }.build(&module)
        };
        Self {
            casters,
            small,
            large,
            depths: raster("light.depths", shader!("light/depths"), DEPTHS_FORMAT),
            shadowed: raster("light.shadowed", shader!("light/shadowed"), SHADOW_FORMAT),
            settle: raster("light.settle", shader!("light/settle"), SHADOW_FORMAT),
        }
    }

    /// Which lights are kept away from what `layers` show.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        lights: &LightsUniform,
        layers: &Layers,
        casting: &Casting<'_>,
    ) -> Transient {
        if lights.casting().next().is_none() || subject.scene.count == 0 {
            let nowhere = frame.texture("light.shadow", [1, 1], SHADOW_FORMAT);
            frame.clear("light.shadow", Target::colour(&nowhere, Some(wgpu::Color::TRANSPARENT)));
            return nowhere;
        }
        casting.reduce.record(frame, casting.pyramid, &layers.depth);
        let size = layers.size.map(|pixels| pixels.div_ceil(casting.step));
        let mask = frame.zeros("light.mask", (size[0] * size[1]).div_ceil(32 / TEXEL_BITS));
        let uniform = |frame: &Frame<'_>, light, channel| {
            let (count, step) = (subject.scene.count, casting.step as f32);
            let uniform = CastingUniform { count, light, channel, step, size, pad: [0; 2] };
            frame.uniform("light.casting", &uniform)
        };
        let whole = uniform(frame, 0, 0);
        let depths = self.depths(frame, &whole, layers, size);
        for (light, channel) in lights.casting() {
            let uniform = uniform(frame, light, 1 << channel);
            self.find_casters(frame, subject, &uniform, casting);
            let all = workgroups(subject.scene.count);
            for (bit, pipeline, groups) in
                [(CASTS_SMALL, &self.small, all), (CASTS_LARGE, &self.large, [TEAMS, 1, 1])]
            {
                let listing = Listing { items: subject.scene.count, mask: bit, quads: 1 };
                casting.compact.record(frame, casting.flags, listing, casting.list);
                let bindings = cast_bindings(subject, &uniform, casting.list, &depths, &mask);
                frame.compute("light.cast", pipeline, &bindings, groups);
            }
        }
        let shadow = frame.texture("light.shadow", size, SHADOW_FORMAT);
        frame.fullscreen(
            "light.shadowed",
            &self.shadowed,
            Target::colour(&shadow, Some(wgpu::Color::TRANSPARENT)),
            &[whole.as_entire_binding(), mask.as_entire_binding()],
        );
        self.settle(frame, shadow, size, casting.settle)
    }

    /// What is seen, as coarse as the mask.
    fn depths(
        &self,
        frame: &mut Frame<'_>,
        casting: &wgpu::Buffer,
        layers: &Layers,
        size: [u32; 2],
    ) -> Transient {
        let depths = frame.texture("light.depths", size, DEPTHS_FORMAT);
        frame.fullscreen(
            "light.depths",
            &self.depths,
            Target::colour(&depths, Some(wgpu::Color::TRANSPARENT)),
            &[casting.as_entire_binding(), wgpu::BindingResource::TextureView(&layers.depth)],
        );
        depths
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

    fn find_casters(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        uniform: &wgpu::Buffer,
        casting: &Casting<'_>,
    ) {
        frame.compute(
            "light.casters",
            &self.casters,
            &[
                subject.view.as_entire_binding(),
                uniform.as_entire_binding(),
                casting.pyramid.uniform.as_entire_binding(),
                subject.lights.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                casting.pyramid.nearness.as_entire_binding(),
                casting.flags.as_entire_binding(),
            ],
            workgroups(subject.scene.count),
        );
    }
}

/// What the kernels that mark the mask read and write.
fn cast_bindings<'a>(
    subject: Subject<'a>,
    uniform: &'a wgpu::Buffer,
    list: &'a DrawList,
    depths: &'a Transient,
    mask: &'a wgpu::Buffer,
) -> [wgpu::BindingResource<'a>; 11] {
    let Atlas { heights, uniform: atlas, .. } = &subject.scene.atlas;
    [
        subject.view.as_entire_binding(),
        atlas.as_entire_binding(),
        uniform.as_entire_binding(),
        subject.lights.as_entire_binding(),
        subject.scene.puffs.as_entire_binding(),
        list.items.as_entire_binding(),
        list.draw.as_entire_binding(),
        subject.scene.styles.as_entire_binding(),
        wgpu::BindingResource::TextureView(heights),
        wgpu::BindingResource::TextureView(depths),
        wgpu::BindingResource::Buffer(mask.as_entire_buffer_binding()),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: CastingUniform, "Casting" of "light/cast" { count, light, channel, step, size });
}
