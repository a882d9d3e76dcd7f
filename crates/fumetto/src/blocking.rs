//! Reading back for those that may block until the device is done: all but a browser's page.

use fumetto_formats::{Drawing, Grid, Image};
use fumetto_scene::Particle;
use pollster::block_on;

use crate::{
    DrawingOptions, Engine, Error, Export, Extent, Layer, LineModel, Player, Print, Shot, Snapshot,
    shapes::surface::SurfaceSize,
};

impl Engine {
    /// Blocks on [`picture_async`](Self::picture_async).
    ///
    /// # Errors
    /// When the picture is too large for the device, or the device is lost.
    pub fn picture(&mut self, player: &Player, shot: &Shot) -> Result<Image, Error> {
        block_on(self.picture_async(player, shot))
    }

    /// Blocks on [`layer_async`](Self::layer_async).
    ///
    /// # Errors
    /// When the picture is too large for the device, or the device is lost.
    pub fn layer(&mut self, player: &Player, shot: &Shot, layer: Layer) -> Result<Image, Error> {
        block_on(self.layer_async(player, shot, layer))
    }

    /// Blocks on [`atlas_async`](Self::atlas_async).
    ///
    /// # Errors
    /// When the device is lost.
    pub fn atlas(&self, player: &Player) -> Result<Vec<(&'static str, Image)>, Error> {
        block_on(self.atlas_async(player))
    }

    /// Blocks on [`snapshot_async`](Self::snapshot_async).
    ///
    /// # Errors
    /// When a number is none, or the device is lost.
    pub fn snapshot(&self, player: &Player, extent: Extent) -> Result<Snapshot, Error> {
        block_on(self.snapshot_async(player, extent))
    }

    /// Blocks on [`surfaces_async`](Self::surfaces_async).
    ///
    /// # Errors
    /// When the device is lost.
    pub fn surfaces(&self, player: &Player) -> Result<Vec<SurfaceSize>, Error> {
        block_on(self.surfaces_async(player))
    }

    /// Blocks on [`solid_async`](Self::solid_async).
    ///
    /// # Errors
    /// When a ramp's picture cannot be read, or the device is lost.
    pub fn solid(&self, player: &Player, object: usize) -> Result<Option<Export>, Error> {
        block_on(self.solid_async(player, object))
    }

    /// Blocks on [`particles_async`](Self::particles_async).
    ///
    /// # Errors
    /// When the device is lost.
    pub fn particles(&self, player: &Player, object: usize) -> Result<Vec<Particle>, Error> {
        block_on(self.particles_async(player, object))
    }

    /// Blocks on [`volume_async`](Self::volume_async).
    ///
    /// # Errors
    /// When a file is gone, or the device is lost.
    pub fn volume(&self, player: &Player, object: usize) -> Result<Vec<Grid>, Error> {
        block_on(self.volume_async(player, object))
    }

    /// Blocks on [`drawing_async`](Self::drawing_async).
    ///
    /// # Errors
    /// When the background's picture cannot be read, or the device is lost.
    pub fn drawing(
        &mut self,
        player: &Player,
        shot: &Shot,
        options: &DrawingOptions,
    ) -> Result<Drawing, Error> {
        block_on(self.drawing_async(player, shot, options))
    }

    /// Blocks on [`line_model_async`](Self::line_model_async).
    ///
    /// # Errors
    /// When the device is lost.
    pub fn line_model(&self, player: &Player) -> Result<LineModel, Error> {
        block_on(self.line_model_async(player))
    }
}

impl Print {
    /// Blocks on [`draw_tile_async`](Self::draw_tile_async).
    ///
    /// # Errors
    /// When the device is lost.
    pub fn draw_tile(&mut self, engine: &mut Engine, player: &Player) -> Result<Option<Image>, Error> {
        block_on(self.draw_tile_async(engine, player))
    }
}
