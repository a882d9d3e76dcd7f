//! Particles out of tables that other programs write, and back.

mod columns;
mod csv;
mod ply;
mod write;

use fumetto_scene::Particle;

pub use self::write::{write_particles_csv, write_particles_ply};
use crate::FormatError;

/// Most particles that a file may hold.
///
/// It is half again as many as the largest scene that the engine is measured with, and 30 MB of
/// memory.
pub const MAX_PARTICLES: usize = 1_500_000;

/// The radius in metres of particles from a file without any: a visible puff in a scene of the
/// usual size of a few metres.
pub const DEFAULT_RADIUS: f32 = 0.1;

/// The mass of particles from a file without any; only relations between masses matter.
pub const DEFAULT_MASS: f32 = 1.0;

/// What a file of particles holds.
#[derive(Clone, Debug, PartialEq)]
pub struct ParticleTable {
    /// The particles in the file's order; at least one, at most [`MAX_PARTICLES`].
    pub particles: Vec<Particle>,
    /// What the user should know about how the file was understood: sentences that name the file.
    pub notes: Vec<String>,
}

/// Reads particles from `bytes`; the extension of `name` (any case) says which format they have.
///
/// `.ply`: the element `vertex`, in text or binary of either byte order. `.csv`: a header line that
/// names the columns, then a line for each particle, separated by commas, semicolons or tabs; lines
/// that start with `#` are comments.
///
/// Columns may stand in any order and are known by name in any case: `x`, `y`, `z` (required),
/// `radius` (or `r`, `pscale`), `mass` (or `m`, `weight`). Without a radius every particle has
/// [`DEFAULT_RADIUS`], without a mass [`DEFAULT_MASS`], and a note says so. Lengths are metres and
/// +Y is up: numbers are taken as they are.
///
/// # Errors
/// If the file is not of its format, holds none or more than [`MAX_PARTICLES`] particles, or any of
/// their values is not finite, or a radius or a mass is not above zero.
pub fn read_particles(name: &str, bytes: &[u8]) -> Result<ParticleTable, FormatError> {
    let extension = name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
    match extension.as_deref() {
        Some("ply") => ply::read(name, bytes),
        Some("csv") => csv::read(name, bytes),
        _ => Err(FormatError::UnknownExtension { file: name.to_owned() }),
    }
}
