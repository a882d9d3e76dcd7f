//! What a scene's volumes are made of at one moment, for other programs.

use std::sync::Arc;

use fumetto_formats::{Grid, GridClass, Voxels};
use glam::{DMat4, DVec3, Vec3};
use half::f16;

use crate::{
    Engine, Error, Player,
    gpu::{GpuError, read_items, read_texture_async},
    player::{PlayedMatter, imported_path, load_imported},
    shapes::volume::{CellField, CellGrid, Samples},
};

impl Engine {
    /// The volume of the scene's `object`-th object at the moment that `player` is at: its density as it is drawn,
    /// and where a file tells it, its temperature. +Y is up. None of an object that is drawn otherwise.
    ///
    /// # Errors
    /// When a file is gone, or the device is lost.
    pub async fn volume_async(&self, player: &Player, object: usize) -> Result<Vec<Grid>, Error> {
        let Some(played) = player.objects.get(object) else { return Ok(Vec::new()) };
        if let PlayedMatter::Imported(volume) = &played.matter {
            let path = imported_path(&volume.imported, player.shown.unwrap_or_default());
            let file = load_imported(player.assets(), &volume.imported, &path)?;
            let samples = Samples::new(&file, &volume.imported);
            return Ok(samples.map_err(|source| Error::Imported { path, source })?.grids());
        }
        match player.volumes.cells(object) {
            Some(field) => Ok(self.grid(field).await?.into_iter().collect()),
            None => Ok(Vec::new()),
        }
    }

    /// The density that was made of puffs, if there is any.
    async fn grid(&self, field: &CellField) -> Result<Option<Grid>, GpuError> {
        let grids: Vec<CellGrid> = read_items(self.gpu(), field.grid(), 0..1).await?;
        let CellGrid { origin, cell_m, cells, .. } = grids[0];
        let texels = read_texture_async(self.gpu(), field.density()).await?;
        let density = |texel: &[u8]| f16::from_le_bytes([texel[6], texel[7]]).to_f32();
        let values: Vec<f32> = texels.chunks_exact(8).map(density).collect();
        let voxels = Voxels::from_dense([0; 3], cells, 1, &values, [0.0; 3]);
        // Samples lie in the middles of cells.
        let first = Vec3::from(origin).as_dvec3() + 0.5 * f64::from(cell_m);
        let world_from_index =
            DMat4::from_translation(first) * DMat4::from_scale(DVec3::splat(f64::from(cell_m)));
        Ok(voxels.map(|voxels| Grid {
            name: "density".to_owned(),
            class: GridClass::FogVolume,
            world_from_index: world_from_index.to_cols_array_2d(),
            voxels: Arc::new(voxels),
        }))
    }
}
