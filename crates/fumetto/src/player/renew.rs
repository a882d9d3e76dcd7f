//! Going on with a scene that was changed while it is played.

use super::{PlayedMatter, Player, motion::Motion};

impl Player {
    /// Takes over how far `earlier` has come, where nothing that moves by itself differs between the two scenes:
    /// a colour or a camera may change without the smoke beginning anew.
    pub(crate) fn take_over(&mut self, earlier: &mut Self) {
        if Motion::of(&self.scene) != Motion::of(&earlier.scene) {
            return;
        }
        for (object, before) in self.objects.iter_mut().zip(&mut earlier.objects) {
            if let (PlayedMatter::Smoke(plume), PlayedMatter::Smoke(moved)) =
                (&mut object.matter, &mut before.matter)
            {
                std::mem::swap(plume, moved);
            }
        }
        std::mem::swap(&mut self.paints, &mut earlier.paints);
        (self.steps, self.can_go_on) = (earlier.steps, earlier.can_go_on);
    }
}
