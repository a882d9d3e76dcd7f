//! Other people's files to plain data, and back.
//!
//! Bytes in, bytes out: this crate opens no file and knows no GPU. Whoever calls it hands over the
//! bytes together with the name that messages shall show.
//!
//! | in | out |
//! |---|---|
//! | particles: [`read_particles`] (PLY, CSV) | |
//! | pictures: [`read_png`] | pictures: [`write_png`] |
//! | | animations: [`GifWriter`] |
//!
//! Any bytes are welcome as input: they give data or an error that names the file and the place,
//! never a panic, a hang or an allocation that the file's own length does not justify.

mod error;
mod excerpt;
mod gif;
mod image;
mod particles;
mod png;
mod sequence;

pub use error::{FormatError, Position, WriteError};
pub use gif::{GifWriter, MAX_GIF_FPS, MIN_GIF_FPS};
pub use image::Image;
pub use particles::{DEFAULT_MASS, DEFAULT_RADIUS, MAX_PARTICLES, ParticleTable, read_particles};
pub use png::{MAX_IMAGE_SIDE, read_png, write_png};
pub use sequence::{is_sequence, sequence_path};
