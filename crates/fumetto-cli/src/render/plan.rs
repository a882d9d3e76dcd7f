use std::path::Path;

use fumetto::{Layer, Shot};
use fumetto_formats::sequence_path;
use fumetto_scene::{Camera, Scene};

use super::with_part;
use crate::args::{FrameRange, RenderArgs, Target, TargetKind};
use crate::exit::Stop;

/// What is to be drawn, from the scene and the command line.
pub(crate) struct Plan {
    pub(crate) frames: FrameRange,
    pub(crate) shot: Shot,
    pub(crate) layers: Vec<Layer>,
    pub(crate) target: Target,
    resume: bool,
}

impl Plan {
    /// Refuses what the command line alone shows to be wrong.
    pub(crate) fn check(args: &RenderArgs) -> Result<(), Stop> {
        let name = &args.out.name;
        let wrong = |problem: String| Err(Stop::Usage(problem));
        match args.out.kind {
            TargetKind::Picture if args.frames.is_some_and(|frames| frames.len() > 1) => {
                let sequence = with_part(name, "####");
                wrong(format!("{name} holds one frame; for --frames name a sequence such as {sequence}"))
            }
            TargetKind::Picture | TargetKind::Animation if args.resume => {
                wrong(format!("--resume goes on with a sequence such as smoke.####.png; {name} is one file"))
            }
            TargetKind::Animation if !args.layers.is_empty() => {
                wrong(format!("--layers are written as .png; {name} is an animation"))
            }
            _ => Ok(()),
        }
    }

    pub(crate) fn new(args: &RenderArgs, scene: &Scene) -> Result<Self, Stop> {
        let is_one = args.out.kind == TargetKind::Picture;
        let frames = FrameRange::chosen(args.frame, args.frames, is_one, scene.time.frames);
        let shot = Shot {
            camera: chosen_camera(scene, args.camera.as_deref())?,
            size: args.size.map_or(scene.output.size, |size| size.0),
            antialias: args.antialias.unwrap_or(scene.output.antialias),
        };
        let mut layers: Vec<Layer> = Vec::new();
        for layer in &args.layers {
            if !layers.contains(layer) {
                layers.push(*layer);
            }
        }
        Ok(Self { frames, shot, layers, target: args.out.clone(), resume: args.resume })
    }

    /// The file that `frame` goes to.
    pub(crate) fn file(&self, frame: u32) -> String {
        sequence_path(&self.target.name, frame)
    }

    /// The file that a layer of `frame` goes to.
    pub(crate) fn layer_file(&self, frame: u32, layer: Layer) -> String {
        with_part(&self.file(frame), &layer.to_string())
    }

    /// The files that the layers of `frame` go to.
    pub(crate) fn layer_files(&self, frame: u32) -> Vec<String> {
        self.layers.iter().map(|&layer| self.layer_file(frame, layer)).collect()
    }

    /// Whether `frame` need not be drawn, because an earlier run has written all its files.
    pub(crate) fn is_done(&self, frame: u32) -> bool {
        let is_file = |name: String| Path::new(&name).is_file();
        self.resume && is_file(self.file(frame)) && self.layer_files(frame).into_iter().all(is_file)
    }
}

/// The camera of that name, or the first.
pub(crate) fn chosen_camera(scene: &Scene, name: Option<&str>) -> Result<Camera, Stop> {
    let found = match name {
        Some(name) => scene.cameras.iter().find(|camera| camera.name == name),
        None => scene.cameras.first(),
    };
    found.cloned().ok_or_else(|| {
        let known: Vec<&str> = scene.cameras.iter().map(|camera| camera.name.as_str()).collect();
        let name = name.unwrap_or_default();
        Stop::Usage(format!("--camera {name}: the scene has no such camera; it has {}", known.join(", ")))
    })
}
