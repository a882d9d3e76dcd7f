use super::At;
use super::values::colour;
use crate::file::{ProfileFile, VolumeFile, VolumeNoiseFile};
use crate::limits::{LIGHT_CELLS, MAX_COLOURS, MAX_VOLUME_BYTES, VOLUME_CELLS};
use crate::{Colour, Matter, Profile, Volume, VolumeNoise};

/// Cells in a step along the line of sight.
const STEP_CELLS: f32 = 0.5;

/// Coarser steps find nothing.
const LONGEST_STEP_CELLS: f32 = 1e3;

/// The shape of puffs, or of what is imported.
pub(super) fn volume(at: &At<'_>, file: &VolumeFile, is_imported: bool) -> Volume {
    if !is_imported && at.key("lobe").exists() {
        let message = "`lobe` is for volumes out of files, and puffs have their own radii".to_owned();
        at.key("lobe").error("wrong-kind", message, "leave it out");
    }
    let scaled = |cells: u32, limit: &crate::limits::Limit| {
        let cells = (f64::from(cells) * f64::from(file.quality)).round();
        limit.clamped(cells) as u32
    };
    Volume {
        extinction_per_m: file.extinction,
        profile: match file.profile {
            ProfileFile::Constant => Profile::Constant,
            ProfileFile::Linear => Profile::Linear,
        },
        edge: file.edge,
        size: file.size,
        noise: file.noise.map(noise),
        colours: colours(&at.key("colours"), file),
        glow: file.glow,
        soft: file.soft,
        surface: file.surface,
        relief: file.relief,
        shadow: file.shadow,
        cells: scaled(file.cells, &VOLUME_CELLS),
        light_cells: scaled(file.light_cells, &LIGHT_CELLS),
        step_m: file.step,
        // The voxels of a file are as many as they are.
        step_cells: if is_imported {
            (STEP_CELLS / file.quality).min(LONGEST_STEP_CELLS)
        } else {
            STEP_CELLS
        },
        pixels: file.pixels,
        lobe_m: file.lobe,
    }
}

fn noise(file: VolumeNoiseFile) -> VolumeNoise {
    VolumeNoise {
        amplitude: file.amplitude,
        frequency: file.frequency,
        octaves: file.octaves,
        persistence: file.persistence,
        lacunarity: file.lacunarity,
        seed: file.seed,
        drift: file.drift,
        billow: file.billow,
    }
}

fn colours(at: &At<'_>, file: &VolumeFile) -> Vec<Colour> {
    let Some(files) = &file.colours else { return vec![Colour { linear: [1.0; 3] }] };
    if files.is_empty() || files.len() > MAX_COLOURS {
        let message = format!("`colours` must name 1 to {MAX_COLOURS} colours, not {}", files.len());
        at.error("colours", message, "each puff takes one of them and keeps it");
    }
    files.iter().take(MAX_COLOURS).enumerate().map(|(i, one)| colour(&at.item(i), one)).collect()
}

/// Refuses grids that are too large, where the scene tells how large they are.
pub(super) fn room(at: &At<'_>, volume: &Volume, matter: &Matter) {
    let room = match matter {
        Matter::Still(particles) => volume.room(particles),
        Matter::Smoke(_) | Matter::Morph(_) => volume.moving_room(),
        Matter::File(_) | Matter::Mesh(_) | Matter::Imported(_) | Matter::Paint(_) => return,
    };
    if !room.fits() {
        let [x, y, z] = room.cells;
        let (asked, allowed) = (room.bytes() / 1_000_000, MAX_VOLUME_BYTES / 1_000_000);
        let message =
            format!("{x} x {y} x {z} cells would take {asked} MB, but at most {allowed} MB are allowed");
        at.key("cells").error("too-many-cells", message, "lower `cells`, `light_cells` or `quality`");
    }
}
