//! What can be wrong with a file that is read or written.

use std::fmt;

/// A file that cannot be read; the message names it, the place in it, and what to do.
#[derive(Debug, thiserror::Error)]
pub enum FormatError {
    /// The name's extension belongs to no format that is read here.
    #[error("{file}: particles are read from `.ply` and `.csv` files; convert this one to either")]
    UnknownExtension {
        /// The file's name as it was given.
        file: String,
    },
    /// The bytes do not follow the format that the name promises.
    #[error("{file}{}: {problem}", position.map(|at| format!(", {at}")).unwrap_or_default())]
    Malformed {
        /// The file's name as it was given.
        file: String,
        /// Where reading stopped, if there is one such place.
        position: Option<Position>,
        /// What is wrong and what to do about it.
        problem: String,
    },
    /// A number that is none, or that no particle can have.
    #[error("{file}, {position}, column `{column}`: `{found}` {problem}")]
    BadValue {
        /// The file's name as it was given.
        file: String,
        /// The row.
        position: Position,
        /// The column's name as the file writes it.
        column: String,
        /// The offending text, or the offending number of a binary file.
        found: String,
        /// What is wrong and what to do about it.
        problem: &'static str,
    },
    /// Particles without a place.
    #[error(
        "{file}: no column is called {missing}; the file has {found}. Name the columns of each particle's \
         centre `x`, `y` and `z`, and if it has them `radius` and `mass`{hint}"
    )]
    MissingColumns {
        /// The file's name as it was given.
        file: String,
        /// The absent columns, quoted, as a list.
        missing: String,
        /// The columns that are there, quoted, as a list.
        found: String,
        /// How this format names its columns; starts with a space or is empty.
        hint: &'static str,
    },
    /// More particles than a scene can hold.
    #[error(
        "{file}: {asked} particles are more than the {allowed} that are allowed; keep every n-th of them"
    )]
    TooManyParticles {
        /// The file's name as it was given.
        file: String,
        /// How many the file holds, or says that it holds.
        asked: u64,
        /// [`MAX_PARTICLES`](crate::MAX_PARTICLES).
        allowed: usize,
    },
    /// A file that is in order but empty.
    #[error("{file}: there is no particle in it; export it again with at least one")]
    NoParticles {
        /// The file's name as it was given.
        file: String,
    },
    /// The name's extension belongs to no format that models are read from.
    #[error("{file}: models are read from `.gltf`, `.glb` and `.obj` files; convert this one to one of them")]
    UnknownModel {
        /// The file's name as it was given.
        file: String,
    },
    /// A part of a file that is not as its format asks.
    #[error("{file}: {element}: {problem}")]
    Element {
        /// The file's name as it was given.
        file: String,
        /// The part, such as `mesh 2 "roof", primitive 0`.
        element: String,
        /// What is wrong and what to do about it.
        problem: String,
    },
    /// A file that this one needs and that cannot be had.
    #[error("{file}: {element}: `{path}` cannot be read ({error}); put it where the model looks for it")]
    Companion {
        /// The file's name as it was given.
        file: String,
        /// What needs it, such as `buffer 0`.
        element: String,
        /// The file that is asked for, seen from where `file` is seen.
        path: String,
        /// Why it cannot be read.
        error: std::io::Error,
    },
    /// Extensions without which a model cannot be understood.
    #[error(
        "{file}: it cannot be read without {names}, which Fumetto does not know; export it again without \
         compression and without extensions"
    )]
    RequiredExtensions {
        /// The file's name as it was given.
        file: String,
        /// The extensions, quoted, as a list.
        names: String,
    },
    /// More triangles than a model may have.
    #[error(
        "{file}: {asked} triangles are more than the {allowed} that are allowed; simplify the model or split it"
    )]
    TooManyTriangles {
        /// The file's name as it was given.
        file: String,
        /// How many the file shows, or says that it shows, where it is known.
        asked: u64,
        /// [`MAX_MODEL_TRIANGLES`](crate::MAX_MODEL_TRIANGLES).
        allowed: u64,
    },
    /// A model in which there is nothing to see.
    #[error("{file}: there is no triangle in it; export it again with at least one mesh in its scene")]
    NoTriangles {
        /// The file's name as it was given.
        file: String,
    },
    /// The name's extension belongs to no format that volumes are read from.
    #[error("{file}: volumes are read from `.vdb`, `.nrrd` and `.npy` files; convert this one to OpenVDB")]
    UnknownVolume {
        /// The file's name as it was given.
        file: String,
    },
    /// None of the grids that are asked for.
    #[error(
        "{file}: there is no grid called {wanted} in it, but {found}; export it again with one of these names"
    )]
    NoGrids {
        /// The file's name as it was given.
        file: String,
        /// The names that are looked for, quoted, as a list.
        wanted: String,
        /// The names that are there, quoted, as a list.
        found: String,
    },
    /// Volumes that would not fit into memory.
    #[error(
        "{file}: its grids have more than the {allowed} numbers that are allowed; export it with larger voxels, or \
         with fewer grids"
    )]
    VolumeTooLarge {
        /// The file's name as it was given.
        file: String,
        /// [`MAX_VOLUME_NUMBERS`](crate::MAX_VOLUME_NUMBERS).
        allowed: u64,
    },
    /// A picture wider or higher than can be drawn with.
    #[error(
        "{file}: {width} × {height} pixels are more than the {allowed} × {allowed} that are allowed; \
         scale the picture down"
    )]
    ImageTooLarge {
        /// The file's name as it was given.
        file: String,
        /// Pixels from left to right.
        width: u32,
        /// Pixels from top to bottom.
        height: u32,
        /// [`MAX_IMAGE_SIDE`](crate::MAX_IMAGE_SIDE).
        allowed: u32,
    },
}

/// A place in a file of particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Position {
    /// A line of text, counted from 1.
    Line(u64),
    /// A vertex of a binary file, counted from 0.
    Vertex(u64),
}

impl fmt::Display for Position {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Vertex(index) => write!(f, "vertex {index}"),
        }
    }
}

/// A file that cannot be written.
///
/// Writers do not know what their output is called: whoever opened it adds the name.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The output refused the bytes.
    #[error("the file cannot be written: {0}")]
    Io(#[from] std::io::Error),
    /// A picture that cannot be stored as it is.
    #[error("a picture of {width} × {height} pixels with {bytes} bytes cannot be written: {problem}")]
    Image {
        /// Pixels from left to right.
        width: u32,
        /// Pixels from top to bottom.
        height: u32,
        /// The length of its pixels.
        bytes: usize,
        /// What is wrong and what to do about it.
        problem: String,
    },
    /// A grid that cannot be stored as it is.
    #[error("the grid `{grid}` cannot be written: {problem}")]
    Volume {
        /// The grid's name.
        grid: String,
        /// What is wrong and what to do about it.
        problem: String,
    },
    /// A frame rate that GIF cannot keep.
    #[error(
        "GIF cannot show {fps} frames a second: viewers keep time between {} and {}; choose a rate in that range",
        crate::MIN_GIF_FPS,
        crate::MAX_GIF_FPS
    )]
    GifRate {
        /// The rate that was asked for.
        fps: f32,
    },
    /// Triangles that nobody could read.
    #[error("the triangles of `{name}` cannot be written: {problem}")]
    Solid {
        /// The solid's name.
        name: String,
        /// What is wrong.
        problem: &'static str,
    },
    /// A drawing that nobody could show.
    #[error("the drawing cannot be written: {problem}")]
    Drawing {
        /// What is wrong.
        problem: &'static str,
    },
    /// More than a binary glTF file can tell the length of.
    #[error("{bytes} bytes are more than the 4 GiB of a .glb file; write .ply, or fewer objects at once")]
    GlbTooLong {
        /// The length of the file.
        bytes: u64,
    },
    /// More vertices than a PLY file can number.
    #[error("{vertices} vertices are more than a .ply file can number; write fewer objects at once")]
    TooManyVertices {
        /// Of all solids.
        vertices: usize,
    },
}
