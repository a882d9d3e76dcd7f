use std::io;

use fumetto_formats::FormatError;
use thiserror::Error;

use crate::{
    TooManyFacets,
    gpu::GpuError,
    shapes::{
        mesh::MeshError,
        puffs::AtlasError,
        surface::SurfaceTooLarge,
        volume::{ImportError, VolumeTooLarge},
    },
};

/// Why a scene cannot be played or drawn.
#[derive(Debug, Error)]
pub enum Error {
    /// A file that the scene names cannot be read.
    #[error("cannot read `{path}`: {source}")]
    Asset {
        /// As the scene names it.
        path: String,
        /// Why.
        source: io::Error,
    },
    /// A file that the scene names does not hold what it should.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// The puffs' pictures do not fit into one texture.
    #[error(transparent)]
    Atlas(#[from] AtlasError),
    /// The models are larger than the device can hold.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A surface is larger than the device can hold.
    #[error("the object `{object}`: {source}")]
    Surface {
        /// Its name.
        object: String,
        /// Which of its lists is too long.
        source: SurfaceTooLarge,
    },
    /// A volume that was read cannot be drawn.
    #[error("{path}: {source}")]
    Imported {
        /// As the scene names it.
        path: String,
        /// Why.
        source: ImportError,
    },
    /// A volume is larger than is allowed.
    #[error("the object `{object}`: {source}")]
    Volume {
        /// Its name.
        object: String,
        /// How large it is.
        source: VolumeTooLarge,
    },
    /// Obstacles cannot be made into the cells of a grid.
    #[error("the obstacles in the air of `{object}`: {source}")]
    Obstacles {
        /// The smoke's name.
        object: String,
        /// Why.
        source: TooManyFacets,
    },
    /// The picture is too large to draw at once.
    #[error(
        "a picture of {width} x {height} pixels with {antialias} samples along each side of a pixel needs a \
         texture {needed} pixels long; this device allows {allowed}. Make `output.size` or `output.antialias` smaller; \
         only .png pictures can be larger than a texture, without layers"
    )]
    TooLarge {
        /// Pixels.
        width: u32,
        /// Pixels.
        height: u32,
        /// Samples along a side.
        antialias: u32,
        /// Width or height in samples.
        needed: u64,
        /// Of the device.
        allowed: u32,
    },
    /// Pixels depend on others so far away that tiles with such margins do not fit a texture.
    #[error(
        "a picture of {width} x {height} pixels with {antialias} samples along each side of a pixel is drawn by \
         tiles with margins of {margin} samples, and textures of this device are {allowed} long. Make \
         `style.clean`, `style.ink.width` or `output.antialias` smaller"
    )]
    Margins {
        /// Pixels.
        width: u32,
        /// Pixels.
        height: u32,
        /// Samples along a side.
        antialias: u32,
        /// Samples.
        margin: u32,
        /// Of the device.
        allowed: u32,
    },
    /// More particles than a storage buffer holds.
    #[error(
        "the scene needs room for {asked} particles at once; this device allows {allowed}. Lower an emitter's \
         `rate`, `count`, `bursts` or `life`"
    )]
    TooMany {
        /// Particles.
        asked: u64,
        /// Of the device.
        allowed: u64,
    },
    /// A number of the simulation is none.
    #[error(
        "frame {frame}: the {quantity} of a particle of `{object}` is no finite number. Make the scene's steps \
         shorter (`time.substeps`), or the forces on it weaker"
    )]
    NotANumber {
        /// From 0.
        frame: u32,
        /// Whose particle it is.
        object: String,
        /// What of it.
        quantity: &'static str,
    },
    /// A snapshot has other parts than the scene.
    #[error("the snapshot of frame {frame} is of another scene")]
    Snapshot {
        /// From 0.
        frame: u32,
    },
    /// The device cannot be had, or failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}
