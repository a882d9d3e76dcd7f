//! What moves of a scene, taken out of the device and put back.

use crate::{
    Engine, Error, Player,
    gpu::read_items,
    particles::{Emission, Particle},
    player::PlayedMatter,
};

/// How much of what moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// What pictures show.
    Shown,
    /// What the simulation needs to go on.
    Whole,
}

/// What moves of a scene at one frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Snapshot {
    /// From 0.
    pub frame: u32,
    /// The contents of buffers; those that pictures show come first.
    pub parts: Vec<Vec<u8>>,
}

impl Player {
    /// Whether anything is simulated.
    #[must_use]
    pub fn simulates(&self) -> bool {
        !self.paints.is_empty() || self.plumes().next().is_some()
    }

    /// What holds the state of what moves: what pictures show first.
    fn state(&self, extent: Extent) -> Vec<&wgpu::Buffer> {
        let mut buffers = Vec::new();
        for plume in self.plumes() {
            buffers.extend(plume.emissions.iter().map(Emission::particles));
        }
        buffers.extend(self.paints.shown());
        if extent == Extent::Whole {
            buffers.extend(self.plumes().flat_map(|plume| plume.hidden()));
            buffers.extend(self.paints.hidden());
        }
        buffers
    }
}

impl Engine {
    /// What moves, at the frame that `player` is at.
    ///
    /// # Errors
    /// When a number is none, or the device is lost.
    pub async fn snapshot_async(&self, player: &Player, extent: Extent) -> Result<Snapshot, Error> {
        let readings: Vec<_> = player
            .state(extent)
            .into_iter()
            .map(|buffer| read_items::<u8>(self.gpu(), buffer, 0..buffer.size() as u32))
            .collect();
        let mut parts = Vec::with_capacity(readings.len());
        for reading in readings {
            parts.push(reading.await?);
        }
        let snapshot = Snapshot { frame: player.shown.unwrap_or_default(), parts };
        check(player, &snapshot)?;
        Ok(snapshot)
    }

    /// Takes the scene to the frame of `snapshot`, which was taken of one that moves alike. From one of the
    /// [whole](Extent::Whole) state the simulation can go on; after another it begins anew.
    ///
    /// # Errors
    /// When the snapshot is of something else, or a file of a sequence is missing or broken.
    pub fn recall(&self, player: &mut Player, snapshot: &Snapshot) -> Result<(), Error> {
        let fits = |buffers: &[&wgpu::Buffer]| {
            let sizes = buffers.iter().map(|buffer| buffer.size());
            sizes.eq(snapshot.parts.iter().map(|part| part.len() as u64))
        };
        player.read_sequences(self.gpu(), snapshot.frame)?;
        let shown = player.state(Extent::Shown);
        let is_whole = fits(&player.state(Extent::Whole));
        if !is_whole && !fits(&shown) {
            return Err(Error::Snapshot { frame: snapshot.frame });
        }
        let buffers = if is_whole { player.state(Extent::Whole) } else { shown };
        for (buffer, part) in buffers.into_iter().zip(&snapshot.parts) {
            self.gpu().queue.write_buffer(buffer, 0, part);
        }
        let steps = player.scene().time.steps_before(snapshot.frame);
        (player.steps, player.can_go_on) = (steps, is_whole);
        self.present(player, snapshot.frame);
        Ok(())
    }
}

/// Refuses numbers that are none.
fn check(player: &Player, snapshot: &Snapshot) -> Result<(), Error> {
    let mut parts = snapshot.parts.iter();
    for (object, played) in player.scene().objects.iter().zip(&player.objects) {
        let PlayedMatter::Smoke(plume) = &played.matter else { continue };
        for part in parts.by_ref().take(plume.emissions.len()) {
            let particles = bytemuck::pod_collect_to_vec::<u8, Particle>(part);
            let mut alive = particles.iter().filter(|particle| !particle.is_dead());
            if let Some(quantity) = alive.find_map(Particle::broken) {
                return Err(Error::NotANumber {
                    frame: snapshot.frame,
                    object: object.name.clone(),
                    quantity,
                });
            }
        }
    }
    Ok(())
}
