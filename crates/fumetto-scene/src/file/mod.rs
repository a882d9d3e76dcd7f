//! The wire shape of a scene: what a TOML file may say, before anything is checked.
//!
//! The doc comments here are the descriptions in the JSON Schema, so they speak to people who write
//! scenes: units, ranges and defaults.

mod grid;
mod hatching;
mod imported;
mod ink;
mod light;
mod mesh;
mod morph;
mod object;
mod paint;
mod scene;
mod smoke;
mod stain;
mod stroke;
mod style;
mod surface;
mod tones;
mod values;
mod volume;
mod vortex;

pub use grid::{EddiesFile, GridBoxFile, GridFile, SourceFile, WallFile, WallsFile};
pub use hatching::{AlongFile, FollowFile, HatchingFile};
pub use imported::{ByteOrderFile, ImportedFile, RawFile, RawNumberFile, ReadFile};
pub use ink::{CreaseFile, HiddenLinesFile, InkFile, InkMethodFile, PenFile, WidthFile};
pub use light::{LampClusterFile, LightFile, SunClusterFile};
pub use mesh::{ScaleFile, TransformFile, UpFile};
pub use morph::{EaseFile, MorphFile};
pub use object::{ObjectFile, ObjectKind, ParticleFile, ParticlesFile, PuffsFile, ShapeFile};
pub use paint::{
    BorderFile, BoxFile, BrushFile, CellsFile, DropFile, GrowthFile, LookFile, PourFile, SpreadFile,
    WashFile, WashModeFile,
};
pub use scene::{BackgroundFile, CameraFile, OutputFile, SceneFile, TimeFile};
pub use smoke::{BurstFile, EmitterFile, EmitterShapeFile, ForceFile};
pub use stain::StainFile;
pub use stroke::StrokeFile;
pub use style::{PixelsFile, ShadingFile, ShadowFile, StyleFile};
pub use surface::{DetailFile, NoiseFile, SurfaceFile};
pub use tones::{
    ExaggerateFile, FocusFile, GoochFile, HighlightFile, PlacedToneFile, RampFile, RampImageFile,
    RampRowsFile, RimFile, StepsFile, ToneFile, TonesFile,
};
pub use values::{ColourFile, CurveFile, OneOrMany, RangeFile};
pub use volume::{ProfileFile, VolumeFile, VolumeNoiseFile};
pub use vortex::{RingsFile, SolverFile, VortexFile};
