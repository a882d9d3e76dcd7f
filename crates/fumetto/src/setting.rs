//! What all cels of one picture share: the view, the lights, and lengths and pens that follow from them.

use fumetto_scene::Object;

use crate::{
    Player,
    cels::Cel,
    gpu::{Frame, Gpu, View},
    ink::{Drawing, MAX_PENS, Moment, Pen, StrokeStyle},
    lengths::{clean_px, smooth_px, wants_turns},
    light::LightsUniform,
    object::ObjectStyle,
    player::Look,
    tone::{Features, HatchStyle, Sheet, Sheeted},
};

/// What all cels of one picture share.
#[derive(Clone, Copy)]
pub(crate) struct Setting<'a> {
    pub(crate) player: &'a Player,
    /// How objects are drawn.
    pub(crate) look: &'a Look,
    pub(crate) view: View,
    pub(crate) lights: LightsUniform,
    pub(crate) features: Features,
    pub(crate) sheet: Sheet,
    pub(crate) moment: Moment,
}

impl<'a> Setting<'a> {
    /// The same, with objects drawn in another look.
    pub(crate) fn in_look(&self, look: &'a Look) -> Self {
        Self { look, features: Features::of(look.drawn(), !self.player.meshes.is_empty()), ..*self }
    }

    /// The scene's objects, then the layers of detail in them.
    pub(crate) fn drawn(&self) -> Vec<&'a Object> {
        self.look.drawn().iter().collect()
    }

    /// The view, the lights and the pens as shaders take them.
    pub(crate) fn buffers(
        &self,
        frame: &Frame<'_>,
        members: &[usize],
    ) -> (wgpu::Buffer, wgpu::Buffer, wgpu::Buffer) {
        (
            frame.uniform("frame.view", &self.view.uniform),
            frame.uniform("frame.lights", &self.lights),
            frame.uniform("frame.pens", &self.pens(members)),
        )
    }

    /// The pens that draw the cel of the objects that `members` numbers.
    pub(crate) fn pens(&self, members: &[usize]) -> [Pen; MAX_PENS] {
        Pen::of_all(&self.drawn(), &self.player.details.with(members), self.view.picture_height)
    }

    /// How strokes are drawn, where there are any in what `members` numbers.
    pub(crate) fn drawing(&self, members: &[usize]) -> Option<Drawing<'_>> {
        let textures = self.player.strokes.as_ref()?;
        self.pens(members).iter().any(Pen::has_strokes).then(|| {
            let styles = StrokeStyle::of_all(&self.drawn(), textures, self.moment);
            Drawing { textures, styles, picture_height: self.view.picture_height }
        })
    }

    /// The objects of a cel.
    pub(crate) fn objects(&self, cel: &Cel) -> impl Iterator<Item = &Object> {
        cel.members.iter().map(|&member| &self.player.scene().objects[member])
    }

    /// How each object is drawn in a cel.
    pub(crate) fn styles(&self, cel: &Cel) -> Vec<ObjectStyle> {
        let style = |(index, object)| {
            let in_cel = cel.members.contains(&(index as usize));
            ObjectStyle::new(object, index, self.view.picture_height, in_cel)
        };
        (0..).zip(self.drawn()).map(style).collect()
    }

    /// All uniforms of a cel in a row, to tell whether anything has changed.
    pub(crate) fn bytes(&self, cel: &Cel) -> Vec<u8> {
        let (view, lights) = (bytemuck::bytes_of(&self.view.uniform), bytemuck::bytes_of(&self.lights));
        [view, lights, bytemuck::cast_slice(&self.styles(cel))].concat()
    }

    /// Length of the shortest line that any object keeps, in samples.
    pub(crate) fn ink_length_px(&self, members: &[usize]) -> f32 {
        self.pens(members).iter().map(Pen::shortest_line_px).fold(0.0, f32::max)
    }

    /// Samples to a texel of the shadow mask: shadows need not be finer than the least tone.
    pub(crate) fn shadow_step(&self) -> u32 {
        match self.clean_px() {
            fine if fine < 1.5 => 1,
            medium if medium < 3.0 => 2,
            _ => 4,
        }
    }

    /// Least size of a tone's shape, in samples.
    pub(crate) fn clean_px(&self) -> f32 {
        clean_px(&self.drawn(), self.view.picture_height)
    }

    /// How all objects are hatched, where any is.
    pub(crate) fn hatching(&self, frame: &Frame<'_>) -> Option<wgpu::Buffer> {
        let sheet = Sheeted { height_px: self.view.picture_height, samples: self.sheet.samples };
        let styles = HatchStyle::list(self.player.scene(), self.look.drawn(), sheet);
        styles.map(|styles| frame.uniform("frame.strokes", &styles))
    }

    /// Samples over which the form is smoothed for strokes, where there are any.
    pub(crate) fn smooth_px(&self) -> Option<f32> {
        smooth_px(&self.drawn(), self.view.picture_height)
    }

    /// Whether any strokes run as the form bends.
    pub(crate) fn wants_turns(&self) -> bool {
        wants_turns(&self.drawn())
    }

    /// Tells shaders how each object is drawn in a cel.
    pub(crate) fn write_styles(&self, gpu: &Gpu, cel: &Cel) {
        gpu.queue.write_buffer(&self.player.puffs.styles, 0, bytemuck::cast_slice(&self.styles(cel)));
    }
}
