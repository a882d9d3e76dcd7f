//! Other people's files to plain data, and back.
//!
//! Bytes in, bytes out: this crate opens no file and knows no GPU. Whoever calls it hands over the
//! bytes together with the name that messages shall show; where a file needs others, as a model needs
//! its textures, they are asked for by path.
//!
//! | in | out |
//! |---|---|
//! | particles: [`read_particles`] (PLY, CSV) | particles: [`write_particles_ply`], [`write_particles_csv`] |
//! | models: [`read_model`] (glTF, OBJ) | triangles: [`write_glb`], [`write_obj`], [`write_solids_ply`] |
//! | volumes: [`read_volume`] (OpenVDB, NRRD, npy), [`read_raw_volume`] | volumes: [`write_vdb`] |
//! | pictures: [`read_png`] | pictures: [`write_png`], [`write_png_bands`] |
//! | | animations: [`GifWriter`] |
//! | caches: [`read_cached_frame`] | caches: [`write_cached_frame`] |
//! | | drawings: [`write_svg`], [`write_animated_svg`], [`write_pdf`] |
//!
//! Any bytes are welcome as input: they give data or an error that names the file and the place,
//! never a panic, a hang or an allocation that the file's own length does not justify.

mod cache;
mod drawing;
mod error;
mod excerpt;
mod gif;
mod image;
mod jpeg;
mod model;
mod notes;
mod particles;
mod png;
mod sequence;
mod solid;
mod volume;

pub use cache::{
    CACHE_HEADER_BYTES, CacheError, CachedFrame, read_cache_fingerprint, read_cached_frame,
    write_cached_frame,
};
pub use drawing::{Drawing, Folder, Item, Paper, Shape, write_animated_svg, write_pdf, write_svg};
pub use error::{FormatError, Position, WriteError};
pub use gif::{GifWriter, MAX_GIF_FPS, MIN_GIF_FPS};
pub use image::Image;
pub use model::{
    DEFAULT_SMOOTH_DEGREES, MAX_MODEL_TRIANGLES, Material, Model, ModelOptions, Part, Placed, Texture, Wrap,
    read_model,
};
pub use particles::{
    DEFAULT_MASS, DEFAULT_RADIUS, MAX_PARTICLES, ParticleTable, read_particles, write_particles_csv,
    write_particles_ply,
};
pub use png::{MAX_IMAGE_SIDE, read_png, write_png, write_png_bands};
pub use sequence::{is_sequence, sequence_path};
pub use solid::{Group, Solid, write_glb, write_mtl, write_obj, write_solids_ply};
pub use volume::{
    BRICK_SIDE, BRICK_VOXELS, Brick, Grid, GridClass, MAX_VOLUME_NUMBERS, Tile, VdbOptions, Volume, Voxels,
    read_raw_volume, read_volume, write_vdb,
};
