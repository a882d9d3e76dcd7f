//! What of a scene decides how it moves.

use std::fmt::{self, Write};

use fumetto_scene::{Matter, Object, Scene};
use twox_hash::xxhash3_128::Hasher;

use super::{PlayedMatter, Player, obstacles::obstacles};
use crate::shapes::mesh::triangles_at;

/// All that smoke and paint depend on: they are in the same state at every step of two scenes that have the same.
#[derive(Debug, PartialEq)]
pub(super) struct Motion<'a> {
    seed: u32,
    fps: f32,
    substeps: u32,
    pre_roll_steps: u64,
    /// Smoke and what it goes round, each with its number, on which chance depends.
    moving: Vec<(usize, &'a Matter)>,
    /// Paint finds its way over whatever surfaces there are, and how it looks is part of it.
    painted: &'a [Object],
}

impl<'a> Motion<'a> {
    pub(super) fn of(scene: &'a Scene) -> Self {
        let moves = |matter: &Matter| match matter {
            Matter::Smoke(_) => true,
            Matter::Mesh(mesh) => mesh.obstacle,
            Matter::Still(_)
            | Matter::File(_)
            | Matter::Morph(_)
            | Matter::Imported(_)
            | Matter::Paint(_) => false,
        };
        let matters = scene.objects.iter().map(|object| &object.matter).enumerate();
        let has_paint = scene.objects.iter().any(|object| matches!(object.matter, Matter::Paint(_)));
        Self {
            seed: scene.seed,
            fps: scene.time.fps,
            substeps: scene.time.substeps,
            pre_roll_steps: scene.time.pre_roll_steps(),
            moving: matters.filter(|(_, matter)| moves(matter)).collect(),
            painted: if has_paint { &scene.objects } else { &[] },
        }
    }
}

/// Hashes what is written.
struct Hashed(Hasher);

impl Write for Hashed {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes());
        Ok(())
    }
}

impl Player {
    /// A number that is the same for all scenes whose smoke and paint move alike, whatever they look like.
    #[must_use]
    pub fn fingerprint(&self) -> u128 {
        let mut hashed = Hashed(Hasher::new());
        // Every number is written in full, and every field with its name.
        let written = write!(hashed, "{:?}", Motion::of(&self.scene));
        debug_assert!(written.is_ok(), "hashing takes whatever comes");
        let models: Box<dyn Iterator<Item = _>> = if self.paints.is_empty() {
            Box::new(obstacles(&self.objects))
        } else {
            Box::new(self.objects.iter().filter_map(|object| match &object.matter {
                PlayedMatter::Model(played) => Some(&**played),
                _ => None,
            }))
        };
        // Of what is animated, the beginning stands for the rest.
        for played in models {
            for corner in triangles_at(&played.mesh, &played.model, 0.0).as_flattened() {
                hashed.0.write(bytemuck::bytes_of(corner));
            }
        }
        hashed.0.finish_128()
    }
}
