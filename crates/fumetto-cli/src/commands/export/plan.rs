use fumetto::{DrawingOptions, Shot};
use fumetto_formats::{is_sequence, sequence_path};
use fumetto_scene::{Matter, Object, Scene};

use crate::args::{DrawingArgs, ExportArgs, ExportTarget, FrameRange, What};
use crate::console;
use crate::exit::Stop;
use crate::render::{chosen_camera, with_part};

/// What is to be exported, from the scene and the command line.
pub(super) struct Plan {
    pub(super) what: What,
    pub(super) target: ExportTarget,
    pub(super) frames: FrameRange,
    /// Numbers of the objects that are written.
    pub(super) objects: Vec<usize>,
    /// Of drawings.
    pub(super) shot: Shot,
    pub(super) options: DrawingOptions,
    /// Frames in a second.
    pub(super) fps: f32,
    json: bool,
}

/// What the command line asks for, unless that alone shows it to be wrong.
pub(super) fn what(args: &ExportArgs) -> Result<What, Stop> {
    let (name, holds) = (&args.out.name, args.out.format.holds());
    let what = args.what.unwrap_or(holds[0]);
    let wrong = |problem: String| Err(Stop::Usage(problem));
    if !holds.contains(&what) {
        let fitting = match what {
            What::Meshes => ".glb, .obj or .ply",
            What::Particles => ".ply or .csv",
            What::Sprites => ".png",
            What::Volumes => ".vdb",
            What::Drawings => ".svg or .pdf",
        };
        return wrong(format!("{name} cannot hold what --what asks for; end its name in {fitting}"));
    }
    let names_moment = args.frame.is_some() || args.frames.is_some() || is_sequence(name);
    if what == What::Sprites && (names_moment || !args.object.is_empty()) {
        return wrong(format!(
            "{name} will hold the pictures of all puffs, which are the same in every frame; \
             leave --frame, --frames, --object and the place for a number out"
        ));
    }
    if what != What::Drawings && args.drawing.is_any() {
        return wrong(format!(
            "--size, --width-mm, --camera and --plotter are for drawings; {name} is none. End its name in .svg or .pdf"
        ));
    }
    let is_one = !is_sequence(name) && what != What::Drawings;
    if is_one && args.frames.is_some_and(|frames| frames.len() > 1) {
        let sequence = with_part(name, "####");
        return wrong(format!("{name} holds one frame; for --frames name a sequence such as {sequence}"));
    }
    Ok(what)
}

impl Plan {
    pub(super) fn new(args: &ExportArgs, what: What, scene: &Scene) -> anyhow::Result<Self> {
        let is_one = !is_sequence(&args.out.name);
        let frames = FrameRange::chosen(args.frame, args.frames, is_one, scene.time.frames);
        let objects = if what == What::Sprites { Vec::new() } else { objects(args, what, scene)? };
        let DrawingArgs { size, width_mm, camera, plotter } = &args.drawing;
        let shot = Shot {
            camera: chosen_camera(scene, camera.as_deref())?,
            size: size.map_or(scene.output.size, |size| size.0),
            antialias: scene.output.antialias,
        };
        let width_mm = width_mm.map(|width| width.0);
        let options = DrawingOptions { objects: objects.clone(), plotter: *plotter, width_mm };
        let (target, fps, json) = (args.out.clone(), scene.time.fps, args.json);
        Ok(Self { what, target, frames, objects, shot, options, fps, json })
    }

    /// The file that `frame` goes to.
    pub(super) fn file(&self, frame: u32) -> String {
        sequence_path(&self.target.name, frame)
    }

    /// Whether several frames go into one file.
    pub(super) fn is_one_of_many(&self) -> bool {
        !is_sequence(&self.target.name) && self.frames.len() > 1
    }

    /// Prints a line for programs, if they want any.
    pub(super) fn tell(&self, line: &serde_json::Value) -> anyhow::Result<()> {
        if self.json {
            console::print(&line.to_string())?;
        }
        Ok(())
    }
}

/// Numbers of the objects that are named, or of all that are visible, as far as they hold `what`.
fn objects(args: &ExportArgs, what: What, scene: &Scene) -> anyhow::Result<Vec<usize>> {
    let known = |name: &&String| scene.objects.iter().any(|object| object.name == **name);
    if let Some(name) = args.object.iter().find(|name| !known(name)) {
        let known: Vec<&str> = scene.objects.iter().map(|object| object.name.as_str()).collect();
        let problem = format!("--object {name}: the scene has no such object; it has {}", known.join(", "));
        return Err(Stop::Usage(problem).into());
    }
    let is_wanted = |object: &Object| match args.object.as_slice() {
        [] => object.visible,
        names => names.contains(&object.name),
    };
    let wanted = || scene.objects.iter().enumerate().filter(|(_, object)| is_wanted(object));
    let found: Vec<usize> =
        wanted().filter(|(_, object)| holds(object, what)).map(|(index, _)| index).collect();
    if found.is_empty() {
        let problem = match what {
            What::Particles => "no object that is to be written has particles; models have none",
            What::Volumes => {
                "no object that is to be written is a volume. Give one `shape = { volume = {} }`, or write its \
                 surface or its particles"
            }
            What::Drawings => "there is no object to be drawn",
            What::Meshes | What::Sprites => {
                "no object that is to be written has triangles; puffs have none. Give one \
                 `shape = { surface = {} }`, or write particles: --what particles, into a .ply or .csv"
            }
        };
        anyhow::bail!("{}: {problem}", args.scene.scene.display());
    }
    for (_, object) in wanted().filter(|(_, object)| !holds(object, what)) {
        let why = match what {
            What::Meshes | What::Sprites => "has no triangles",
            What::Particles => "has no particles",
            What::Volumes => "has no volume",
            What::Drawings => "is not visible",
        };
        console::say(&format!("note: `{}` {why} and is left out", object.name));
    }
    Ok(found)
}

fn holds(object: &Object, what: What) -> bool {
    let is_model = matches!(object.matter, Matter::Mesh(_));
    match what {
        What::Meshes => is_model || object.shape.surface().is_some(),
        What::Particles => !is_model && !matches!(object.matter, Matter::Imported(_) | Matter::Paint(_)),
        What::Volumes => !is_model && object.shape.volume().is_some(),
        What::Drawings => object.visible,
        What::Sprites => false,
    }
}
