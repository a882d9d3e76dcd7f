//! Volumes out of files, as they are played.

use fumetto_formats::{FormatError, Volume, is_sequence, read_raw_volume, read_volume, sequence_path};
use fumetto_scene::{Imported, Particle, Shape};

use crate::{
    Assets, Error,
    assets::read,
    gpu::Gpu,
    shapes::volume::{BrickField, BrickMap, ImportError, Samples},
};

/// A volume out of a file, at one of its files.
#[derive(Debug)]
pub(crate) struct PlayedVolume {
    pub(crate) imported: Imported,
    /// Of a sequence, which file it is.
    number: u32,
    detail: Detail,
    pub(crate) field: BrickField,
    /// Balls that stand for it where particles are asked for: lobes, or of a surface what covers it.
    pub(crate) balls: Vec<Particle>,
    /// The largest density in it.
    pub(super) peak: f32,
}

/// What a shape asks of a volume.
#[derive(Clone, Copy, Debug)]
struct Detail {
    /// Cells of light along its longest side.
    light_cells: u32,
    /// Radius of its lobes, where the scene says it.
    lobe_m: Option<f32>,
    is_surface: bool,
}

impl Detail {
    fn of(shape: &Shape) -> Self {
        let (light_cells, lobe_m) =
            shape.volume().map_or((1, None), |volume| (volume.light_cells, volume.lobe_m));
        Self { light_cells, lobe_m, is_surface: shape.surface().is_some() }
    }
}

/// How much a volume out of a file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImportedSize {
    /// Voxels with any matter.
    pub voxels: u64,
    /// Bricks of 8³ voxels that are kept.
    pub bricks: u32,
    /// Bytes of the bricks and of the table that finds them.
    pub bytes: u64,
    /// Balls that cover it: what a surface is planned with.
    pub cover: Vec<Particle>,
}

impl PlayedVolume {
    /// At the scene's `frame`; adds what the user should know about the file to `notes`.
    pub(crate) fn new(
        gpu: &Gpu,
        assets: &dyn Assets,
        imported: &Imported,
        frame: u32,
        shape: &Shape,
        notes: &mut Vec<String>,
    ) -> Result<Self, Error> {
        Self::at(gpu, assets, imported, (frame, Detail::of(shape)), notes)
    }

    fn at(
        gpu: &Gpu,
        assets: &dyn Assets,
        imported: &Imported,
        (frame, detail): (u32, Detail),
        notes: &mut Vec<String>,
    ) -> Result<Self, Error> {
        let (number, imported) = (imported.number_at(frame), imported.clone());
        let map = map(assets, &imported, frame, detail.lobe_m, notes)?;
        let field = field(gpu, &map, &imported, (frame, detail.light_cells))?;
        let balls = if detail.is_surface { map.cover } else { map.lobes };
        Ok(Self { imported, number, detail, field, balls, peak: map.peak })
    }

    /// Reads the file for the scene's `frame`, if it is another: whether it is.
    pub(crate) fn seek(&mut self, gpu: &Gpu, assets: &dyn Assets, frame: u32) -> Result<bool, Error> {
        let number = self.imported.number_at(frame);
        if number == self.number || !self.is_sequence() {
            return Ok(false);
        }
        *self = Self::at(gpu, assets, &self.imported, (frame, self.detail), &mut Vec::new())?;
        Ok(true)
    }

    pub(crate) fn is_sequence(&self) -> bool {
        is_sequence(&self.imported.file)
    }
}

/// How much a volume holds at the scene's `frame`; no graphics device is needed to tell.
///
/// # Errors
/// When its file is missing or broken, or holds too much.
pub fn imported_size(assets: &dyn Assets, imported: &Imported, frame: u32) -> Result<ImportedSize, Error> {
    let map = map(assets, imported, frame, None, &mut Vec::new())?;
    Ok(ImportedSize { voxels: map.voxels, bricks: map.bricks(), bytes: map.bytes(), cover: map.cover })
}

fn map(
    assets: &dyn Assets,
    imported: &Imported,
    frame: u32,
    lobe_m: Option<f32>,
    notes: &mut Vec<String>,
) -> Result<BrickMap, Error> {
    let path = path(imported, frame);
    let volume = load(assets, imported, &path)?;
    notes.extend(volume.notes.iter().cloned());
    let map = Samples::new(&volume, imported).and_then(|samples| BrickMap::new(&samples, lobe_m));
    let map = map.map_err(|source| Error::Imported { path: path.clone(), source })?;
    if map.voxels == 0 {
        notes.push(format!("{path}: there is no matter in it; a `range` that begins lower may show some"));
    }
    Ok(map)
}

fn field(
    gpu: &Gpu,
    map: &BrickMap,
    imported: &Imported,
    (frame, light): (u32, u32),
) -> Result<BrickField, Error> {
    let refused = |source: ImportError| Error::Imported { path: path(imported, frame), source };
    BrickField::new(gpu, map, light).map_err(refused)
}

/// Of the file that the scene's `frame` shows.
pub(crate) fn path(imported: &Imported, frame: u32) -> String {
    sequence_path(&imported.file, imported.number_at(frame))
}

/// Reads a volume's file, and of its grids those that are needed.
pub(crate) fn load(assets: &dyn Assets, imported: &Imported, path: &str) -> Result<Volume, Error> {
    let bytes = read(assets, path)?;
    if let Some(raw) = &imported.raw {
        return Ok(read_raw_volume(path, &bytes, raw)?);
    }
    let density = imported.density.as_deref().unwrap_or("density");
    let wanted: Vec<&str> = imported.heat.as_deref().into_iter().chain([density]).collect();
    match read_volume(path, &bytes, &wanted) {
        // Whatever the file calls its only density.
        Err(FormatError::NoGrids { .. }) if imported.density.is_none() => Ok(read_volume(path, &bytes, &[])?),
        Ok(volume) if imported.density.is_none() && !volume.grids.iter().any(|grid| grid.name == density) => {
            Ok(read_volume(path, &bytes, &[])?)
        }
        read => Ok(read?),
    }
}
