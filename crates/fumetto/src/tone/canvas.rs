use crate::gpu::Target;

/// What tones are painted onto.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Canvas<'a> {
    pub(crate) view: &'a wgpu::TextureView,
    /// Whether it is the picture itself, with what lies under the cel laid already, and not a cel of its own.
    pub(crate) is_picture: bool,
}

impl<'a> Canvas<'a> {
    /// A cel begins empty.
    pub(crate) fn target(self) -> Target<'a> {
        Target::colour(self.view, (!self.is_picture).then_some(wgpu::Color::TRANSPARENT))
    }
}
