//! What may stand on the command line.

mod export;
mod frames;
mod setting;
mod size;
mod target;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use fumetto::Layer;

pub(crate) use self::{
    export::{ExportTarget, Format, What},
    frames::FrameRange,
    setting::Setting,
    size::{Millimetres, Size},
    target::{Target, TargetKind},
};

/// Draws smoke, clouds and fog as a cartoonist would.
///
/// Exit codes: 0 done, 1 failed, 2 wrong usage, 130 stopped by Ctrl-C.
#[derive(Debug, Parser)]
#[command(name = "fumetto", version)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Draw a scene to a picture, a sequence of pictures or an animation.
    Render(RenderArgs),
    /// Write what a scene's drawings are made of.
    Export(ExportArgs),
    /// Simulate a scene once, so that its frames can be drawn in any order, and on several machines.
    Bake(BakeArgs),
    /// Tell every problem of a scene, with line and column.
    Check(CheckArgs),
    /// Tell what is in a scene, and what it will cost.
    Info(InfoArgs),
    /// Write a commented scene to start from.
    New(NewArgs),
    /// Open the editor, where it is installed beside this program.
    Edit(EditArgs),
    /// Print the JSON Schema of scene files, with which text editors complete and check them.
    Schema,
    /// Tell which graphics adapters there are, and what to install when there is none.
    Doctor,
}

/// A scene and what is changed in it.
#[derive(Args, Debug)]
pub(crate) struct SceneArgs {
    /// The scene file, or `-` for one that comes in by a pipe. Files that it names are looked for beside it, or, of
    /// `-`, where the program runs.
    pub(crate) scene: PathBuf,
    /// A preset or a style file, in place of the scene's `style` table.
    #[arg(long, value_name = "NAME|FILE")]
    pub(crate) style: Option<String>,
    /// Change a key of the scene, as in `--set camera.eye[0]=2` or `--set object.smoke.opacity=0.5`;
    /// may be given several times.
    #[arg(long, value_name = "PATH=VALUE")]
    pub(crate) set: Vec<Setting>,
}

#[derive(Args, Debug)]
pub(crate) struct RenderArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Where to write. `smoke.png` is one picture; `smoke.####.png` (or `smoke.{}.png`) a picture for
    /// each frame; `smoke.gif` an animation, transparent if the scene's background is.
    #[arg(short, long = "output", value_name = "OUT")]
    pub(crate) out: Target,
    /// Draw this frame only. Without it a single .png shows the scene's last frame, because smoke takes
    /// time to rise; sequences and animations show all frames.
    #[arg(long, value_name = "N", conflicts_with = "frames")]
    pub(crate) frame: Option<u32>,
    /// Draw these frames, the first and the last included.
    #[arg(long, value_name = "A..B")]
    pub(crate) frames: Option<FrameRange>,
    /// Width and height in pixels, in place of the scene's.
    #[arg(long, value_name = "WxH")]
    pub(crate) size: Option<Size>,
    /// The camera to look through, where the scene has several. Default: the first.
    #[arg(long, value_name = "NAME")]
    pub(crate) camera: Option<String>,
    /// Samples along each side of a pixel, 1 (hard edges) to 4, in place of the scene's.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=4))]
    pub(crate) antialias: Option<u32>,
    /// A folder that `fumetto bake` filled. Frames of which it has the simulation are not simulated again.
    #[arg(long, value_name = "DIR")]
    pub(crate) cache: Option<PathBuf>,
    /// Write these layers beside each .png, as in `smoke.0001.normal.png`: normal, depth, id, alpha, ink.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) layers: Vec<Layer>,
    /// Skip the frames of a sequence whose files are there already.
    #[arg(long)]
    pub(crate) resume: bool,
    /// Print a JSON object for each frame, and one at the end.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct ExportArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Where to write; the extension says what. `.svg` and `.pdf` are drawings of closed shapes and lines;
    /// with --frames, a single .svg moves and a .pdf has a page for each frame. `.glb`, `.obj` and `.ply`
    /// are triangles: surfaces and models. `.csv`, and `.ply` with `--what particles`, are particles. `.vdb`
    /// are volumes, for OpenVDB. `puffs.png` are the pictures of
    /// all puffs side by side, for engines that draw them as billboards: puffs.normal.png,
    /// puffs.depth.png and puffs.coverage.png. `smoke.####.glb` is a file for each frame.
    #[arg(short, long = "output", value_name = "OUT")]
    pub(crate) out: ExportTarget,
    /// What to write, where OUT's extension leaves a choice: a `.ply` holds triangles unless this asks for
    /// particles.
    #[arg(long, value_enum)]
    pub(crate) what: Option<What>,
    /// Only this object, visible or not; may be given several times. Default: all that are visible.
    #[arg(long, value_name = "NAME")]
    pub(crate) object: Vec<String>,
    /// This frame only. Without it a single file shows the scene's last frame, and a sequence all frames.
    #[arg(long, value_name = "N", conflicts_with = "frames")]
    pub(crate) frame: Option<u32>,
    /// These frames, the first and the last included.
    #[arg(long, value_name = "A..B")]
    pub(crate) frames: Option<FrameRange>,
    /// A folder that `fumetto bake` filled. Frames of which it has the simulation are not simulated again.
    #[arg(long, value_name = "DIR")]
    pub(crate) cache: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) drawing: DrawingArgs,
    /// Print a JSON object for each file, and one at the end.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct BakeArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// The folder that the frames go to; it is made if there is none. What an earlier run left there is kept, and
    /// the simulation goes on from there.
    #[arg(short, long = "output", value_name = "DIR")]
    pub(crate) out: PathBuf,
    /// These frames, the first and the last included. Default: all of the scene.
    #[arg(long, value_name = "A..B")]
    pub(crate) frames: Option<FrameRange>,
    /// Print a JSON object for each frame, and one at the end.
    #[arg(long)]
    pub(crate) json: bool,
}

/// What only drawings have.
#[derive(Args, Debug)]
pub(crate) struct DrawingArgs {
    /// Of a drawing: width and height in pixels, in place of the scene's.
    #[arg(long, value_name = "WxH")]
    pub(crate) size: Option<Size>,
    /// Of a drawing: its width on paper in millimetres. Default: 96 pixels to the inch.
    #[arg(long, value_name = "MM")]
    pub(crate) width_mm: Option<Millimetres>,
    /// Of a drawing: the camera to look through. Default: the first.
    #[arg(long, value_name = "NAME")]
    pub(crate) camera: Option<String>,
    /// Of a drawing: only lines, along their middles, for machines that hold a pen.
    #[arg(long)]
    pub(crate) plotter: bool,
}

impl DrawingArgs {
    /// Whether any of it is said.
    pub(crate) fn is_any(&self) -> bool {
        self.size.is_some() || self.width_mm.is_some() || self.camera.is_some() || self.plotter
    }
}

#[derive(Args, Debug)]
pub(crate) struct CheckArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
}

#[derive(Args, Debug)]
pub(crate) struct InfoArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Print one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct NewArgs {
    /// What the scene is called: NAME.toml is written, and an existing file is left alone.
    pub(crate) name: PathBuf,
    /// What to start from.
    #[arg(long, value_enum, default_value_t = Template::Smoke)]
    pub(crate) template: Template,
}

#[derive(Args, Debug)]
pub(crate) struct EditArgs {
    /// The scene file to open.
    pub(crate) scene: Option<PathBuf>,
}

/// What a new scene starts from.
#[derive(Clone, Copy, Debug, Eq, PartialEq, ValueEnum)]
pub(crate) enum Template {
    /// A column of smoke that rises and drifts.
    Smoke,
    /// A still cloud of a few particles.
    Cloud,
    /// A burst, a fireball and what is left of it.
    Explosion,
}
