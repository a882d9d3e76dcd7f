use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{ColourFile, LightFile, ObjectFile, OneOrMany, StyleFile};
use crate::limits;

/// A Fumetto scene. Right-handed, +Y up, metres, seconds, degrees.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Fumetto scene")]
pub struct SceneFile {
    /// The version of this format. Write `format = 1`.
    #[schemars(range(min = 1, max = 1))]
    pub format: u32,
    /// What every random choice is made from. Default 1.
    #[serde(default = "one")]
    pub seed: u32,
    /// Where the picture is taken from: `[camera]`, or several named `[[camera]]`.
    pub camera: Option<OneOrMany<CameraFile>>,
    /// What shines on the objects; up to 8.
    #[serde(default)]
    pub light: Vec<LightFile>,
    /// What lies behind the objects. Default: nothing, so the picture is transparent there.
    pub background: Option<BackgroundFile>,
    /// The clock.
    #[serde(default)]
    pub time: TimeFile,
    /// The picture.
    #[serde(default)]
    pub output: OutputFile,
    /// How every object is drawn, unless it says otherwise.
    #[serde(default)]
    pub style: StyleFile,
    /// Everything that is drawn; up to 64.
    #[serde(default)]
    pub object: Vec<ObjectFile>,
}

fn one() -> u32 {
    1
}

/// A pinhole camera.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct CameraFile {
    /// What it is chosen by; needed where there are several. Default "main".
    #[serde(default = "main_camera")]
    pub name: String,
    /// Where it stands, in metres.
    pub eye: [f32; 3],
    /// What it looks at, in metres; not the same place as `eye`.
    pub target: [f32; 3],
    /// Which way is up; not along the line of sight. Default `[0, 1, 0]`.
    #[serde(default = "up")]
    pub up: [f32; 3],
    /// Vertical field of view in degrees, above 0 and below 180. Default 40.
    #[serde(default = "fov")]
    #[schemars(transform = &limits::FOV_DEG)]
    pub fov: f32,
    /// Distance of the near plane in metres. Default: a hundredth of the way from `eye` to `target`.
    #[schemars(transform = &limits::LENGTH)]
    pub near: Option<f32>,
}

fn main_camera() -> String {
    "main".into()
}

fn up() -> [f32; 3] {
    [0.0, 1.0, 0.0]
}

fn fov() -> f32 {
    40.0
}

/// What lies behind the objects: exactly one of these.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct BackgroundFile {
    /// One colour.
    pub colour: Option<ColourFile>,
    /// From the top edge to the bottom edge.
    pub gradient: Option<[ColourFile; 2]>,
    /// A PNG, scaled to cover the picture and centred; relative to the scene file.
    #[schemars(extend("x-files" = ["png"]))]
    pub image: Option<String>,
    /// Paper of this colour, with its tooth.
    pub paper: Option<ColourFile>,
}

/// The clock.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct TimeFile {
    /// Frames in a second, above 0. Default 24.
    #[schemars(transform = &limits::FPS)]
    pub fps: f32,
    /// First and last frame; the simulation starts at frame 0, or `pre_roll` before it. Default `[0, 119]`.
    pub frames: [u32; 2],
    /// Draw on ones (1), twos (2), threes…; the simulation still steps every frame. Default 1.
    #[schemars(transform = &limits::HOLD)]
    pub hold: u32,
    /// Simulation steps in a frame, 1 to 16. Default 1.
    #[schemars(transform = &limits::SUBSTEPS)]
    pub substeps: u32,
    /// Seconds that are simulated before frame 0, so that it shows smoke already, 0 to 600. Smoke's and paint's
    /// own moments count from their beginning. Default 0.
    #[schemars(transform = &limits::PRE_ROLL_SECS)]
    pub pre_roll: f32,
}

impl Default for TimeFile {
    fn default() -> Self {
        Self { fps: 24.0, frames: [0, 119], hold: 1, substeps: 1, pre_roll: 0.0 }
    }
}

/// The picture.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct OutputFile {
    /// Width and height in pixels, each 1 to 32768. Default `[1280, 720]`.
    #[schemars(transform = &limits::PICTURE_PX)]
    pub size: [u32; 2],
    /// Samples along each side of a pixel, 1 (hard edges) to 4. Default 2.
    #[schemars(transform = &limits::ANTIALIAS)]
    pub antialias: u32,
}

impl Default for OutputFile {
    fn default() -> Self {
        Self { size: [1280, 720], antialias: 2 }
    }
}
