//! Pictures of any size, drawn tile by tile.

use fumetto_formats::Image;

use crate::{
    Engine, Error, Player, Shot,
    engine::picture_texture,
    gpu::{Region, read_texture_async},
    ink::InkAround,
    lengths::reach_px,
    tiles::{Part, Survey, Tile, Tiles, Tiling},
};

/// A picture that is drawn tile by tile and handed over in bands from the top, so that no more of it than a
/// band is ever held.
///
/// ```no_run
/// # fn write(_: fumetto_formats::Image) {}
/// # fn print(engine: &mut fumetto::Engine, player: &fumetto::Player) -> Result<(), fumetto::Error> {
/// let shot = fumetto::Shot { size: [12_000, 9_000], ..fumetto::Shot::of(player.scene()) };
/// let mut print = engine.print(player, &shot, fumetto::Tiling::default())?;
/// while !print.is_done() {
///     if let Some(band) = print.draw_tile(engine, player)? {
///         write(band);
///     }
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Print {
    shot: Shot,
    tiles: Tiles,
    survey: Option<Survey>,
    /// The next tile: column and row.
    next: [u32; 2],
    band: Image,
    /// Of the textures that were drawn into last, in samples.
    drawn: [u32; 2],
}

impl Engine {
    /// Prepares a picture of any size of the moment that `player` is at. It can be drawn until that moment
    /// changes.
    ///
    /// # Errors
    /// When the margins of tiles do not fit the device.
    pub fn print(&mut self, player: &Player, shot: &Shot, tiling: Tiling) -> Result<Print, Error> {
        let samples = shot.samples();
        let allowed = self.gpu().device.limits().max_texture_dimension_2d;
        let reach_px = reach_px(player, samples[1]);
        let tiles = Tiles::new(tiling, samples, reach_px, allowed).ok_or_else(|| {
            let ([width, height], antialias) = (shot.size, shot.antialias);
            Error::Margins { width, height, antialias, margin: reach_px.ceil() as u32, allowed }
        })?;
        let survey = (!tiles.is_whole()).then(|| self.survey(player, shot));
        let band = Image { width: shot.size[0], height: 0, pixels: Vec::new() };
        Ok(Print { shot: shot.clone(), tiles, survey, next: [0, 0], band, drawn: [0, 0] })
    }

    /// Draws the whole picture smaller, to learn which lines are too short to read.
    fn survey(&mut self, player: &Player, shot: &Shot) -> Survey {
        let shot = Shot { size: Survey::size(shot.samples()), antialias: 1, ..shot.clone() };
        let part = Part { region: Region::whole(shot.size), survey: None };
        Survey { height: shot.size[1], arounds: self.draw_part(player, &shot, part).1 }
    }

    fn draw_part(&mut self, player: &Player, shot: &Shot, part: Part<'_>) -> (wgpu::Texture, Vec<InkAround>) {
        self.look(player, &shot.camera);
        let gpu = self.gpu().clone();
        let texture = picture_texture(&gpu, part.region.size.map(|side| side / shot.antialias));
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let arounds = self.painter.paint(&gpu, &self.pool, player, shot, part, &view);
        self.pool.end_frame();
        (texture, arounds)
    }
}

impl Print {
    /// How many tiles there are.
    #[must_use]
    pub fn tile_count(&self) -> u32 {
        let [columns, rows] = self.tiles.grid();
        columns * rows
    }

    /// How many of them have been drawn.
    #[must_use]
    pub fn drawn_count(&self) -> u32 {
        self.next[1] * self.tiles.grid()[0] + self.next[0]
    }

    /// Whether all have been drawn.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.next[1] >= self.tiles.grid()[1]
    }

    /// Draws the next tile. Answers with the next rows of the picture when they are complete.
    ///
    /// # Errors
    /// When the device is lost.
    pub async fn draw_tile_async(
        &mut self,
        engine: &mut Engine,
        player: &Player,
    ) -> Result<Option<Image>, Error> {
        if self.is_done() {
            return Ok(None);
        }
        let [column, row] = self.next;
        let tile = self.tiles.tile(column, row);
        if self.drawn != tile.region.size {
            // Textures of another size are of no use for a while, and large.
            engine.pool.clear();
            self.drawn = tile.region.size;
        }
        let part = Part { region: tile.region, survey: self.survey.as_ref() };
        let (texture, _) = engine.draw_part(player, &self.shot, part);
        let pixels = read_texture_async(engine.gpu(), &texture).await?;
        self.keep(&tile, &pixels);
        if column + 1 < self.tiles.grid()[0] {
            self.next = [column + 1, row];
            return Ok(None);
        }
        self.next = [0, row + 1];
        let next = Image { width: self.shot.size[0], height: 0, pixels: Vec::new() };
        Ok(Some(std::mem::replace(&mut self.band, next)))
    }

    /// Copies what is kept of a tile's `pixels` to its place in the band.
    fn keep(&mut self, tile: &Tile, pixels: &[u8]) {
        let in_px = |samples: u32| (samples / self.shot.antialias) as usize;
        let [left, width] = [tile.first[0], tile.size[0]].map(in_px);
        let [skipped, above] = [0, 1].map(|axis| in_px(tile.first[axis] - tile.region.first[axis]));
        let (drawn_width, height) = (in_px(tile.region.size[0]), in_px(tile.size[1]));
        self.band.height = height as u32;
        self.band.pixels.resize(4 * self.band.width as usize * height, 0);
        let rows = pixels.chunks_exact(4 * drawn_width).skip(above);
        for (row, drawn) in self.band.pixels.chunks_exact_mut(4 * self.band.width as usize).zip(rows) {
            row[4 * left..4 * (left + width)].copy_from_slice(&drawn[4 * skipped..4 * (skipped + width)]);
        }
    }
}
