//! Vector drawings: a moment as closed shapes and lines, for programs in which people go on drawing.
//!
//! Tones are traced in the picture's own samples, so that a drawing shows what the picture shows: `seen.rs` tells
//! whose each sample is, `regions.rs` what hangs together, `borders.rs` finds the borders between regions,
//! `smooth.rs` and `fit.rs` make curves of them, and `fills.rs` closed paths. Lines of surfaces and models come of
//! their triangles, all others are traced likewise.

mod borders;
mod cel_lines;
mod document;
mod fills;
mod fit;
mod inked;
mod lines;
mod model;
mod paper;
mod reduce;
mod regions;
mod seen;
mod smooth;
mod thin;
mod traced;

pub use model::LineModel;

use fumetto_formats::{Drawing, Paper};

use crate::{Engine, Error, Player, Shot};

/// Samples along each side of a pixel that shapes are traced in: a border is known to an eighth of a pixel.
const FINENESS: f64 = 4.0;

/// Samples beyond which fewer are taken of each pixel: what is traced is held in memory, some 30 bytes a sample.
const MOST_SAMPLES: f64 = 16_777_216.0;

/// How a drawing is made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawingOptions {
    /// Numbers of the objects that are in it; all that are visible, unless there are any. Others hide them as ever.
    pub objects: Vec<usize>,
    /// Only lines, along their middles: for machines that hold a pen.
    pub plotter: bool,
    /// Width on paper in millimetres.
    pub width_mm: Option<f64>,
}

impl Engine {
    /// The moment that `player` is at as a drawing of closed shapes and lines.
    ///
    /// The shot's size is the drawing's; its `antialias` says nothing about shapes that have no pixels.
    ///
    /// # Errors
    /// When the background's picture cannot be read, or the device is lost.
    pub async fn drawing_async(
        &mut self,
        player: &Player,
        shot: &Shot,
        options: &DrawingOptions,
    ) -> Result<Drawing, Error> {
        let gpu = self.gpu().clone();
        let traced =
            Shot { size: traced_size(shot.size, &gpu.device.limits()), antialias: 1, ..shot.clone() };
        self.look(player, &shot.camera);
        let plates = self.painter.plates(&gpu, &self.pool, player, &traced).await?;
        self.pool.end_frame();
        let paper = match options.plotter {
            true => Paper::Clear,
            false => paper::paper(player.scene(), player.assets())?,
        };
        let mut strokes = Vec::with_capacity(plates.len());
        for plate in &plates {
            strokes.push(cel_lines::lines(&gpu, (player, shot), plate, options).await?);
        }
        Ok(document::drawing(player, shot.size, plates.iter().zip(strokes), paper, options))
    }
}

/// Size of the picture that shapes are traced in.
fn traced_size(size: [u32; 2], limits: &wgpu::Limits) -> [u32; 2] {
    let [width, height] = size.map(f64::from);
    let most = f64::from(limits.max_texture_dimension_2d) / width.max(height);
    let fineness = FINENESS.min((MOST_SAMPLES / (width * height)).sqrt()).min(most);
    // Whole numbers keep pixels whole.
    let fineness = if fineness > 1.0 { fineness.floor() } else { fineness };
    [width, height].map(|side| ((side * fineness) as u32).max(1))
}
