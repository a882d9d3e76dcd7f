use std::ops::Range;

use fumetto_scene::{Profile, Volume, VolumeNoise, limits};

/// What is made of an object's puffs, and how it is looked at.
#[derive(Clone, Debug)]
pub(crate) struct Recipe {
    pub(crate) volume: Volume,
    /// The object's puffs in the list of all.
    pub(crate) puffs: Range<u32>,
    /// Whether its particles move.
    pub(crate) moves: bool,
    /// Whether it keeps light from itself.
    pub(crate) shadows: bool,
    /// Whether it may keep light from other things.
    pub(crate) casts: bool,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct RecipeUniform {
    first: u32,
    count: u32,
    is_linear: u32,
    edge: f32,
    amplitude: f32,
    frequency: f32,
    octaves: u32,
    persistence: f32,
    lacunarity: f32,
    seed: u32,
    billow: u32,
    moves: u32,
    drift: [f32; 3],
    colour_count: u32,
    extinction: f32,
    glow: f32,
    soft: f32,
    surface: f32,
    step_m: f32,
    shadows: u32,
    step_cells: f32,
    murk: f32,
    pixels: f32,
    pad: [f32; 3],
    colours: [[f32; 4]; limits::MAX_COLOURS],
}

impl Recipe {
    /// At a moment of the scene.
    pub(super) fn uniform(&self, time_secs: f32) -> RecipeUniform {
        let volume = &self.volume;
        let still = VolumeNoise {
            amplitude: 0.0,
            frequency: 1.0,
            octaves: 1,
            persistence: 0.0,
            lacunarity: 1.0,
            seed: 0,
            drift: [0.0; 3],
            billow: true,
        };
        let noise = volume.noise.unwrap_or(still);
        let mut colours = [[1.0; 4]; limits::MAX_COLOURS];
        for (slot, colour) in colours.iter_mut().zip(&volume.colours) {
            slot[..3].copy_from_slice(&colour.linear);
        }
        RecipeUniform {
            first: self.puffs.start,
            count: self.puffs.len() as u32,
            is_linear: u32::from(volume.profile == Profile::Linear),
            edge: volume.edge,
            amplitude: noise.amplitude,
            frequency: noise.frequency,
            octaves: noise.octaves,
            persistence: noise.persistence,
            lacunarity: noise.lacunarity,
            seed: noise.seed,
            billow: u32::from(noise.billow),
            moves: u32::from(self.moves),
            drift: noise.drift.map(|speed| -speed * time_secs),
            colour_count: self.volume.colours.len().clamp(1, limits::MAX_COLOURS) as u32,
            extinction: volume.extinction_per_m,
            glow: volume.glow,
            soft: volume.soft,
            surface: volume.surface,
            step_m: volume.step_m.unwrap_or(0.0),
            shadows: u32::from(self.shadows),
            step_cells: volume.step_cells,
            murk: if self.casts { volume.shadow } else { 0.0 },
            pixels: volume.pixels as f32,
            pad: [0.0; 3],
            colours,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: RecipeUniform, "Recipe" of "shapes/volume/march" { first, count, is_linear, edge, amplitude, frequency, octaves, persistence, lacunarity, seed, billow, moves, drift, colour_count, extinction, glow, soft, surface, step_m, shadows, step_cells, murk, pixels, colours });
}
