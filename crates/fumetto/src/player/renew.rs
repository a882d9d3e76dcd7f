//! Going on with a scene that was changed while it is played.

use fumetto_scene::{Matter, Scene};

use super::{PlayedMatter, Player};

impl Player {
    /// Takes over how far `earlier` has come, where nothing that moves by itself differs between the two scenes:
    /// a colour or a camera may change without the smoke beginning anew.
    pub(crate) fn take_over(&mut self, earlier: &mut Self) {
        if !moves_alike(&self.scene, &earlier.scene) {
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
        self.steps = earlier.steps;
    }
}

/// Whether smoke and paint are in the same state at every step of both scenes.
fn moves_alike(scene: &Scene, other: &Scene) -> bool {
    let (objects, others) = (&scene.objects, &other.objects);
    // Paint finds its way over whatever surfaces there are, and how it looks is part of it.
    let has_paint = objects.iter().any(|object| matches!(object.matter, Matter::Paint(_)));
    (scene.seed, scene.time.fps, scene.time.substeps) == (other.seed, other.time.fps, other.time.substeps)
        && objects.len() == others.len()
        && objects
            .iter()
            .zip(others)
            .all(|(object, other)| object.matter == other.matter && (!has_paint || object == other))
}
