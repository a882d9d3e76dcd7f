//! Pre-shaded puff sprites.

use std::sync::{Arc, Mutex, PoisonError};

use super::{CEL_FORMAT, Ramps};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader},
    shapes::puffs::{Atlas, Subject},
};

/// Width of a sprite, and how many ways it is turned. Also in `sprite_tile.wgsl`.
const SPRITE_PX: u32 = 64;
const ROTATIONS: u32 = 16;

/// Objects whose sprites fit below each other in a texture of `WebGPU`'s default limits.
pub(crate) const MAX_OBJECTS: usize = 8192 / (SPRITE_PX * ROTATIONS) as usize;

/// The long-lived pipeline, and what it drew last.
#[derive(Debug)]
pub(crate) struct Sprites {
    pipeline: RenderPipeline,
    last: Mutex<Option<Shaded>>,
}

/// Sprites, and what they came of.
#[derive(Debug)]
struct Shaded {
    look: Vec<u8>,
    atlas: wgpu::TextureView,
    ramps: wgpu::TextureView,
    sprites: Arc<Transient>,
}

impl Sprites {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("tone/sprites"));
        let pipeline = RasterPipeline { label: "tone.sprites", targets: &[CEL_FORMAT], ..Default::default() };
        Self { pipeline: pipeline.build(&module), last: Mutex::new(None) }
    }

    /// Every variant of every object in every rotation, shaded. `look` is all that this depends on beside the
    /// scene's atlas and `ramps`: while none of it changes, the sprites of the last picture are good.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        ramps: &Ramps,
        look: Vec<u8>,
    ) -> Arc<Transient> {
        let (atlas, ramps_view) = (&subject.scene.atlas.view, &ramps.view);
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(last) = last.as_ref()
            && (&last.look, &last.atlas, &last.ramps) == (&look, atlas, ramps_view)
        {
            return Arc::clone(&last.sprites);
        }
        let sprites = Arc::new(self.shade(frame, subject, ramps));
        let (atlas, ramps) = (atlas.clone(), ramps_view.clone());
        *last = Some(Shaded { look, atlas, ramps, sprites: Arc::clone(&sprites) });
        sprites
    }

    fn shade(&self, frame: &mut Frame<'_>, subject: Subject<'_>, ramps: &Ramps) -> Transient {
        let Atlas { view: texture, sampler, uniform, variants, .. } = &subject.scene.atlas;
        let objects = subject.scene.objects.len() as u32;
        let size = [variants * SPRITE_PX, objects * ROTATIONS * SPRITE_PX];
        let sprites = frame.texture("tone.sprites", size, CEL_FORMAT);
        frame.fullscreen(
            "tone.sprites",
            &self.pipeline,
            Target::colour(&sprites, Some(wgpu::Color::TRANSPARENT)),
            &[
                subject.view.as_entire_binding(),
                uniform.as_entire_binding(),
                subject.lights.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                wgpu::BindingResource::TextureView(texture),
                wgpu::BindingResource::Sampler(sampler),
                wgpu::BindingResource::TextureView(&ramps.view),
            ],
        );
        sprites
    }
}
