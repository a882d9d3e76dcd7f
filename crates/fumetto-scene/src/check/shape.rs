use super::{At, ink::ink, volume::volume};
use crate::file::{DetailFile, NoiseFile, PuffsFile, ShapeFile, SurfaceFile, VolumeFile};
use crate::{Detail, Noise, Puffs, Resolution, Shape, Style, Surface};

/// Cells along the longest side, unless the file says how fine.
const SUBDIVISIONS: u32 = 48;

/// Where a surface lies, unless the file says so: of particles, and of a volume out of a file.
const THRESHOLDS: [f32; 2] = [0.05, 0.5];

/// Lengths in pixels are meant for a picture `height_px` high. What is imported is a volume unless it says
/// otherwise.
pub(super) fn shape(at: &At<'_>, file: Option<&ShapeFile>, is_imported: bool, height_px: f32) -> Shape {
    match file {
        Some(ShapeFile::Volume(file)) => Shape::Volume(volume(&at.key("volume"), file, is_imported)),
        Some(ShapeFile::Puffs(file)) => Shape::Puffs(puffs(&at.key("puffs"), *file)),
        Some(ShapeFile::Surface(file)) => {
            Shape::Surface(surface(&at.key("surface"), file, is_imported, height_px))
        }
        None if is_imported => Shape::Volume(volume(&at.key("volume"), &VolumeFile::default(), is_imported)),
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

fn surface(at: &At<'_>, file: &SurfaceFile, is_imported: bool, height_px: f32) -> Surface {
    let pixels = file.pixels.map(|px| px / height_px);
    let choices = choices(file.subdivisions, file.cell, file.per_radius, pixels);
    Surface {
        threshold: file.threshold.unwrap_or(THRESHOLDS[usize::from(is_imported)]),
        resolution: resolution(at, "surface", choices).unwrap_or(Resolution::Subdivisions(SUBDIVISIONS)),
        size: file.size,
        noise: file.noise.map(noise),
    }
}

fn noise(file: NoiseFile) -> Noise {
    Noise {
        amplitude: file.amplitude,
        size_m: file.size,
        octaves: file.octaves,
        seed: file.seed,
        drift_m_per_s: file.drift,
    }
}

/// The layers of detail in the `shape` of an object in this `style`.
pub(super) fn details(at: &At<'_>, file: Option<&ShapeFile>, shape: &Shape, style: &Style) -> Vec<Detail> {
    let (Some(ShapeFile::Surface(file)), Some(outer)) = (file, shape.surface()) else { return Vec::new() };
    let at = at.key("surface").key("detail");
    let files = file.detail.as_deref().unwrap_or_default();
    files.iter().enumerate().map(|(i, file)| detail(&at.item(i), file, outer, style)).collect()
}

fn detail(at: &At<'_>, file: &DetailFile, outer: &Surface, style: &Style) -> Detail {
    let pixels = file.pixels.map(|px| px / style.height_px);
    let choices = choices(file.subdivisions, file.cell, file.per_radius, pixels);
    let surface = Surface {
        threshold: file.threshold.unwrap_or(outer.threshold),
        resolution: resolution(at, "detail", choices).unwrap_or(outer.resolution),
        size: file.size * outer.size,
        noise: file.noise.map(noise).or(outer.noise),
    };
    let mut own = style.ink.clone();
    if let Some(file) = &file.ink {
        ink(&at.key("ink"), file, &mut own);
    }
    Detail { surface, mass: file.mass, ink: own }
}

type Choices = [Option<Resolution>; 4];

/// `share` is of the picture's height.
fn choices(
    subdivisions: Option<u32>,
    cell: Option<f32>,
    per_radius: Option<f32>,
    share: Option<f32>,
) -> Choices {
    [
        subdivisions.map(Resolution::Subdivisions),
        cell.map(Resolution::Cell),
        per_radius.map(Resolution::PerRadius),
        share.map(Resolution::Picture),
    ]
}

/// How finely `what` is sampled, if the file says so.
fn resolution(at: &At<'_>, what: &str, choices: Choices) -> Option<Resolution> {
    let mut chosen = choices.into_iter().flatten();
    let first = chosen.next();
    if chosen.next().is_some() {
        let message =
            format!("`{what}` must have only one of `subdivisions`, `cell`, `per_radius` and `pixels`");
        let help = "each says how finely the surface is sampled; keep the one that you mean";
        at.error("surface-choice", message, help);
    }
    first
}
