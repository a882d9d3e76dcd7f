//! The drawing layers: what every shape fills and every style reads.

use crate::gpu::{Frame, Target, Transient};

/// Reverse-Z depth: 1 at the near plane, 0 where there is nothing.
pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Number of the puff + 1, 0 where there is nothing.
pub(crate) const ID_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R32Uint;

/// World-space normal; logarithm to base 2 of the distance in metres.
pub(crate) const NORMAL_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// Of a volume's surface: number of the puff + 1, bits of the depth, octahedral normal, and colour in four bytes.
pub(crate) const HITS_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Uint;

/// How much of each light that throws shadows comes through a volume to its surface.
pub(crate) const LIGHT_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// A volume as a camera would see it: linear, times its opacity.
pub(crate) const SOFT_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// The layers of one cel.
#[derive(Debug)]
pub(crate) struct Layers {
    pub(crate) size: [u32; 2],
    /// Whether its depth began with that of another cel.
    pub(crate) is_over: bool,
    pub(crate) depth: Transient,
    pub(crate) id: Transient,
    /// These three are of volumes, and of one pixel where there is none.
    pub(crate) hits: Transient,
    pub(crate) light: Transient,
    pub(crate) soft: Transient,
}

impl Layers {
    /// Takes layers from the frame's pool; they hold nothing sensible yet.
    pub(crate) fn new(frame: &Frame<'_>, size: [u32; 2]) -> Self {
        Self {
            size,
            is_over: false,
            depth: frame.texture("layers.depth", size, DEPTH_FORMAT),
            id: frame.texture("layers.id", size, ID_FORMAT),
            hits: frame.texture("layers.hits", [1, 1], HITS_FORMAT),
            light: frame.texture("layers.light", [1, 1], LIGHT_FORMAT),
            soft: frame.texture("layers.soft", [1, 1], SOFT_FORMAT),
        }
    }

    /// Makes room for what volumes fill; it holds nothing sensible yet.
    pub(crate) fn add_volumes(&mut self, frame: &Frame<'_>) {
        self.hits = frame.texture("layers.hits", self.size, HITS_FORMAT);
        self.light = frame.texture("layers.light", self.size, LIGHT_FORMAT);
        self.soft = frame.texture("layers.soft", self.size, SOFT_FORMAT);
    }

    /// Empties the layers; only what lies before the depth `nearer` will be drawn.
    pub(crate) fn begin(&mut self, frame: &mut Frame<'_>, nearer: Option<&Transient>) {
        self.is_over = nearer.is_some();
        if let Some(nearer) = nearer {
            let (from, to) = (nearer.texture(), self.depth.texture());
            frame.encoder.copy_texture_to_texture(from.as_image_copy(), to.as_image_copy(), from.size());
        }
        let clear = nearer.is_none().then_some(0.0);
        let target = Target::colour(&self.id, Some(wgpu::Color::TRANSPARENT)).with_depth(&self.depth, clear);
        frame.clear("layers.begin", target);
    }

    /// Where shapes draw.
    pub(crate) fn target(&self) -> Target<'_> {
        Target::colour(&self.id, None).with_depth(&self.depth, None)
    }
}

/// Depth state of shapes: the nearest surface stays.
pub(crate) fn nearest_wins() -> wgpu::DepthStencilState {
    depth_state(true, wgpu::CompareFunction::Greater)
}

/// Depth state of what must lie in front of every shape to be seen, but hides nothing itself.
pub(crate) fn in_front() -> wgpu::DepthStencilState {
    depth_state(false, wgpu::CompareFunction::Greater)
}

/// Depth state of full-screen passes that only concern pixels with a shape: their triangle lies
/// infinitely far away, and whatever is nearer passes.
pub(crate) fn where_filled() -> wgpu::DepthStencilState {
    depth_state(false, wgpu::CompareFunction::Less)
}

fn depth_state(write: bool, compare: wgpu::CompareFunction) -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format: DEPTH_FORMAT,
        depth_write_enabled: Some(write),
        depth_compare: Some(compare),
        stencil: wgpu::StencilState::default(),
        bias: wgpu::DepthBiasState::default(),
    }
}
