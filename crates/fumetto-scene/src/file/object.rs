use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{
    BorderFile, BoxFile, BrushFile, CellsFile, DropFile, EmitterFile, ForceFile, GridFile, ImportedFile,
    LookFile, MorphFile, OneOrMany, PourFile, SolverFile, SpreadFile, StainFile, StyleFile, SurfaceFile,
    TransformFile, UpFile, VolumeFile, VortexFile, WashFile,
};
use crate::limits;

/// A thing in the scene: matter, its shape, and how it is drawn.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct ObjectFile {
    /// What it is called; no two objects share a name.
    pub name: String,
    /// What it is made of.
    pub kind: ObjectKind,
    /// Whether it is drawn. Default true.
    #[serde(default = "yes")]
    pub visible: bool,
    /// Flat transparency of the whole object, 0 (gone) to 1 (opaque). Default 1.
    #[serde(default = "opaque")]
    #[schemars(transform = &limits::SHARE)]
    pub opacity: f32,
    /// The particles of a `kind = "cloud"`: listed here, or a .ply or .csv file relative to the scene
    /// file; `####` or `{}` in its name numbers a sequence by frame.
    pub particles: Option<ParticlesFile>,
    /// What the particles of a `kind = "cloud"` become: tables in the order of time.
    pub morph: Option<Vec<MorphFile>>,
    /// Where the particles of a `kind = "smoke"` come from: one table, or several `[[object.emitter]]`.
    pub emitter: Option<OneOrMany<EmitterFile>>,
    /// What moves the particles of a `kind = "smoke"`.
    pub force: Option<Vec<ForceFile>>,
    /// What else moves the particles of a `kind = "smoke"`: "vortex" (the default) makes them curl, "grid" simulates
    /// the air around them, "forces" leaves it at the forces.
    pub solver: Option<SolverFile>,
    /// How the vortices of `solver = "vortex"` are shed, and what becomes of them.
    pub vortex: Option<VortexFile>,
    /// The box of air of `solver = "grid"`.
    pub grid: Option<GridFile>,
    /// The model of a `kind = "mesh"`: a .glb, .gltf or .obj file relative to the scene file.
    #[schemars(extend("x-files" = ["glb", "gltf", "obj"]))]
    pub model: Option<String>,
    /// The volume of a `kind = "volume"`: a .vdb, .nrrd or .npy file relative to the scene file, or a table that
    /// also says how it is read; `####` or `{}` in its name numbers a sequence by frame.
    pub volume: Option<ImportedFile>,
    /// Which way is up in the file of the model or volume: "y" (the default, as in glTF) or "z".
    pub up: Option<UpFile>,
    /// Works the model's normals out anew: faces that meet at a smaller angle than this, in degrees, blend.
    /// Without it the file's own are kept.
    #[schemars(transform = &limits::ANGLE_DEG)]
    pub smooth: Option<f32>,
    /// Where the model of a `kind = "mesh"` stands: one table, or several `[[object.transform]]` for
    /// several copies. The volume of a `kind = "volume"` has one.
    pub transform: Option<OneOrMany<TransformFile>>,
    /// Whether the smoke of `solver = "grid"` goes round a `kind = "mesh"`. Default false.
    pub obstacle: Option<bool>,
    /// Drops of a `kind = "paint"`: one table, or several `[[object.drop]]`.
    pub drop: Option<OneOrMany<DropFile>>,
    /// Strokes of a brush of a `kind = "paint"`: one table, or several `[[object.stroke]]`.
    pub stroke: Option<OneOrMany<BrushFile>>,
    /// Paint that is poured into the `cells` of a `kind = "paint"`: one table, or several `[[object.pour]]`.
    pub pour: Option<OneOrMany<PourFile>>,
    /// The grid that poured paint of a `kind = "paint"` runs in.
    pub cells: Option<CellsFile>,
    /// Paint of a `kind = "paint"` that the particles of a smoke leave on the models that they touch: one table, or
    /// several `[[object.stain]]`.
    pub stain: Option<OneOrMany<StainFile>>,
    /// How paint of a `kind = "paint"` spreads.
    pub spread: Option<SpreadFile>,
    /// Paint of a `kind = "paint"` stays in this box.
    pub keep: Option<BoxFile>,
    /// What a `kind = "paint"` lays over what it covers, step by step.
    pub wash: Option<WashFile>,
    /// A line along the edge of a `kind = "paint"`.
    pub border: Option<BorderFile>,
    /// How a `kind = "paint"` draws what it covers: "own" (the default), "monochrome", or a table of style keys.
    pub inside: Option<LookFile>,
    /// How what no paint covers is drawn: "monochrome" (the default where there is a `kind = "paint"`), "own",
    /// or a table of style keys. Only one paint may say.
    pub outside: Option<LookFile>,
    /// How matter gets a shape. Default: puffs, and for a `kind = "volume"` a volume.
    pub shape: Option<ShapeFile>,
    /// How it is drawn: the scene's style with these changes.
    pub style: Option<StyleFile>,
}

fn yes() -> bool {
    true
}

fn opaque() -> f32 {
    1.0
}

/// What an object is made of.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ObjectKind {
    /// Particles that emitters make and forces move.
    Smoke,
    /// Particles that are given.
    Cloud,
    /// A model: a house, a train, a lamp.
    Mesh,
    /// A volume that another program made.
    Volume,
    /// Paint that spreads over all else, and changes how that is drawn.
    Paint,
}

impl ObjectKind {
    pub(crate) const ALL: [Self; 5] = [Self::Smoke, Self::Cloud, Self::Mesh, Self::Volume, Self::Paint];
}

/// Particles that are given.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ParticlesFile {
    /// The path of a .ply or .csv file.
    Path(#[schemars(extend("x-files" = ["ply", "csv"]))] String),
    /// One by one.
    List(Vec<ParticleFile>),
}

/// A weighted particle: a soft ball of matter.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct ParticleFile {
    /// Where it is, in metres.
    pub center: [f32; 3],
    /// How far its matter reaches, in metres, above 0.
    #[schemars(transform = &limits::LENGTH)]
    pub radius: f32,
    /// How much matter it holds, relative to its neighbours, above 0. Default 1.
    #[serde(default = "mass")]
    #[schemars(transform = &limits::MASS)]
    pub mass: f32,
}

fn mass() -> f32 {
    1.0
}

/// How matter gets a shape.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ShapeFile {
    /// Every particle is a billboard of one of a few pre-rendered bundles of balls.
    Puffs(PuffsFile),
    /// All particles together become one closed skin.
    Surface(SurfaceFile),
    /// Matter that light goes through: every particle is a puff of it, and all together are one field.
    Volume(VolumeFile),
}

/// Bundles of balls.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct PuffsFile {
    /// How many different puffs there are, 1 to 16. Default 4.
    #[schemars(transform = &limits::VARIANTS)]
    pub variants: u32,
    /// What they are made from. Default 1.
    pub seed: u32,
    /// Balls in each puff, 1 to 256. Default 24.
    #[schemars(transform = &limits::SPHERES)]
    pub spheres: u32,
    /// Width of a puff's picture in pixels: 16, 32, 64, 128, 256 or 512. Default 128.
    #[schemars(transform = &limits::TILE_PX)]
    pub tile: u32,
    /// The puff's radius over the particle's radius, above 0. Default 1.
    #[schemars(transform = &limits::SCALE)]
    pub size: f32,
}

impl Default for PuffsFile {
    fn default() -> Self {
        Self { variants: 4, seed: 1, spheres: 24, tile: 128, size: 1.0 }
    }
}
