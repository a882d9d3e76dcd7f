use super::At;
use crate::file::{NoiseFile, PuffsFile, ShapeFile, SurfaceFile};
use crate::{Noise, Puffs, Resolution, Shape, Surface};

/// Cells along the longest side, unless the file says how fine.
const SUBDIVISIONS: u32 = 48;

pub(super) fn shape(at: &At<'_>, file: Option<&ShapeFile>) -> Shape {
    match file {
        Some(ShapeFile::Puffs(file)) => Shape::Puffs(puffs(&at.key("puffs"), *file)),
        Some(ShapeFile::Surface(file)) => Shape::Surface(surface(&at.key("surface"), file)),
        None => Shape::Puffs(puffs(&at.key("puffs"), PuffsFile::default())),
    }
}

fn puffs(at: &At<'_>, file: PuffsFile) -> Puffs {
    let PuffsFile { variants, seed, spheres, tile, size } = file;
    if !tile.is_power_of_two() {
        let message = format!("`tile` must be a power of two, not {tile}");
        let nearest = tile.next_power_of_two();
        at.key("tile").error("not-a-power-of-two", message, format!("{} and {nearest} are", nearest / 2));
    }
    Puffs { variants, seed, spheres, tile_px: tile, size }
}

fn surface(at: &At<'_>, file: &SurfaceFile) -> Surface {
    let noise = |file: NoiseFile| Noise {
        amplitude: file.amplitude,
        size_m: file.size,
        octaves: file.octaves,
        seed: file.seed,
    };
    Surface {
        threshold: file.threshold,
        resolution: resolution(at, file),
        size: file.size,
        noise: file.noise.map(noise),
    }
}

fn resolution(at: &At<'_>, file: &SurfaceFile) -> Resolution {
    match (file.subdivisions, file.cell, file.per_radius) {
        (None, None, None) => Resolution::Subdivisions(SUBDIVISIONS),
        (Some(cells), None, None) => Resolution::Subdivisions(cells),
        (None, Some(cell_m), None) => Resolution::Cell(cell_m),
        (None, None, Some(cells)) => Resolution::PerRadius(cells),
        _ => {
            let message = "`surface` must have only one of `subdivisions`, `cell` and `per_radius`";
            let help = "each says how finely the surface is sampled; keep the one that you mean";
            at.error("surface-choice", message.into(), help);
            Resolution::Subdivisions(SUBDIVISIONS)
        }
    }
}
