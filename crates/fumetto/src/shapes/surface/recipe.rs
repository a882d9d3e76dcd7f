use std::ops::Range;

use fumetto_scene::{Noise, Spacing, Surface, SurfaceRoom};
use glam::Vec3;

use super::{bins::sharers, sight::Sight};
use crate::shapes::{mesh::Reserved, volume::BrickField};

/// What is made of an object's puffs.
#[derive(Clone, Debug)]
pub(crate) struct Recipe {
    /// The object's puffs in the list of all.
    pub(crate) puffs: Range<u32>,
    /// *T* of Álvarez's equation 3.
    pub(crate) threshold: f32,
    /// Multiplies all radii; an inner layer of detail has less than 1 (section 5).
    pub(crate) radius_scale: f32,
    /// Multiplies all masses.
    pub(crate) mass_scale: f32,
    pub(crate) spacing: Spacing,
    /// From where it is seen, where cells are lengths on the picture.
    pub(crate) sight: Option<Sight>,
    pub(crate) noise: Option<Noise>,
    /// Where a file tells the density: the puffs only cover it.
    pub(crate) bricks: Option<BrickField>,
}

/// Octaves beyond this are smaller than a rounding error.
const MOST_OCTAVES: u32 = 16;
/// More than any table of blocks holds.
const MOST_SUBDIVISIONS: f32 = 65_536.0;
/// Numbers that divide, and may not be zero.
const LEAST: f32 = 1e-6;

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct RecipeUniform {
    first: u32,
    count: u32,
    radius_scale: f32,
    mass_scale: f32,
    threshold: f32,
    cell_m: f32,
    subdivisions: f32,
    part: u32,
    noise_amplitude: f32,
    noise_per_m: f32,
    noise_octaves: u32,
    noise_seed: u32,
    blocks: u32,
    entries: u32,
    active_blocks: u32,
    vertices: u32,
    triangles: u32,
    first_vertex: u32,
    first_triangle: u32,
    sharers: u32,
    noise_offset_m: [f32; 3],
    cell_per_m: f32,
    eye: [f32; 3],
    regions: u32,
}

impl Recipe {
    /// For the shape `surface` of `puffs`. They bring the factor of their radius along; what is left of it is
    /// among the scales, of radii and masses.
    pub(super) fn new(
        surface: &Surface,
        [radius_scale, mass_scale]: [f32; 2],
        puffs: Range<u32>,
        spacing: Spacing,
    ) -> Self {
        let (threshold, noise) = (surface.threshold, surface.noise);
        Self { puffs, threshold, radius_scale, mass_scale, spacing, sight: None, noise, bricks: None }
    }

    /// Of the moment `secs`.
    pub(super) fn uniform(&self, secs: f32, room: SurfaceRoom, mesh: &Reserved) -> RecipeUniform {
        let (cell_m, subdivisions, share) = match self.spacing {
            Spacing::Cell(cell_m) => (kept(cell_m, LEAST, 1.0 / LEAST), 1.0, 0.0),
            Spacing::Subdivisions(subdivisions) => (0.0, kept(subdivisions, 1.0, MOST_SUBDIVISIONS), 0.0),
            Spacing::Picture { share, most } => (0.0, kept(most, 1.0, MOST_SUBDIVISIONS), share),
        };
        let (eye, height_m) = self.sight.map_or((Vec3::ZERO, 0.0), |sight| (sight.eye, sight.height_m));
        let quiet = Noise { amplitude: 0.0, size_m: 1.0, octaves: 0, seed: 0, drift_m_per_s: [0.0; 3] };
        let noise = self.noise.unwrap_or(quiet);
        let count = (self.puffs.len() as u32).min(room.particles);
        RecipeUniform {
            first: self.puffs.start,
            count,
            radius_scale: self.radius_scale,
            mass_scale: self.mass_scale,
            threshold: self.threshold.max(LEAST),
            cell_m,
            subdivisions,
            part: mesh.part,
            noise_amplitude: noise.amplitude.max(0.0),
            noise_per_m: 1.0 / kept(noise.size_m, LEAST, 1.0 / LEAST),
            noise_octaves: noise.octaves.min(MOST_OCTAVES),
            noise_seed: noise.seed,
            blocks: room.blocks,
            entries: room.entries,
            active_blocks: room.active,
            vertices: mesh.vertices.len() as u32,
            triangles: mesh.triangles.len() as u32,
            first_vertex: mesh.vertices.start,
            first_triangle: mesh.triangles.start,
            sharers: sharers(count),
            noise_offset_m: noise.drift_m_per_s.map(|m_per_s| m_per_s * secs),
            cell_per_m: kept(share * height_m, 0.0, 1.0 / LEAST),
            eye: eye.to_array(),
            regions: room.regions,
        }
    }
}

/// Within bounds; what is no number becomes the lower.
fn kept(value: f32, low: f32, high: f32) -> f32 {
    if value.is_nan() { low } else { value.clamp(low, high) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: RecipeUniform, "Recipe" of "shapes/surface/bounds" { first, count, radius_scale, mass_scale, threshold, cell_m, subdivisions, part, noise_amplitude, noise_per_m, noise_octaves, noise_seed, blocks, entries, active_blocks, vertices, triangles, first_vertex, first_triangle, sharers, noise_offset_m, cell_per_m, eye, regions });
}
