use std::collections::HashSet;

use super::values::{colour, cross, direction, length, unit};
use super::{
    At, Styles,
    light::lights,
    object::object,
    paint::{enough_room, looks},
    stain::stains,
};
use crate::file::{BackgroundFile, CameraFile, SceneFile, TimeFile};
use crate::limits::{MAX_OBJECTS, MAX_STROKE_PICTURES, MIN_DIRECTION, MIN_UP_SINE};
use crate::{Background, Camera, Object, Output, Scene, Time};

/// The scene that `file` describes.
pub(crate) fn scene(at: &At<'_>, file: &SceneFile, styles: &mut Styles<'_>) -> Scene {
    let style = styles.scene_style(&at.key("style"), &file.style);
    let time = time(&at.key("time"), &file.time);
    let objects = file.object.iter().enumerate().take(MAX_OBJECTS);
    let mut objects: Vec<Object> = objects
        .map(|(i, one)| object(&at.key("object").item(i), one, &style, time.step_secs(), styles))
        .collect();
    looks(&at.key("object"), &file.object, &mut objects, styles);
    stains(&at.key("object"), &file.object, &mut objects, time.step_secs());
    enough_room(&at.key("object"), &objects);
    let names = file.object.iter().map(|object| object.name.as_str());
    unique_names(&at.key("object"), names, "object");
    at_most(
        &at.key("object"),
        "object",
        file.object.len(),
        MAX_OBJECTS,
        "join some: an object may have many emitters",
    );
    let details = objects.iter().map(|object| object.details.len()).sum::<usize>();
    if details > 0 && objects.len() + details > MAX_OBJECTS {
        let message = format!(
            "there are {} objects and {details} layers of detail, but at most {MAX_OBJECTS} of both are allowed",
            objects.len()
        );
        at.key("object").error("too-many", message, "leave some layers of detail out");
    }
    if file.object.is_empty() {
        let help = "add an [[object]] with a `name` and a `kind`";
        at.key("object").warning("no-object", "the scene has no object, so nothing is drawn".into(), help);
    }
    let output = Output { size: file.output.size, antialias: file.output.antialias };
    let scene = Scene {
        seed: file.seed,
        cameras: cameras(&at.key("camera"), file),
        lights: lights(&at.key("light"), &file.light),
        background: background(&at.key("background"), file.background.as_ref()),
        time,
        output,
        objects,
    };
    few_pictures(&at.key("object"), &scene);
    scene
}

/// Refuses more pictures for strokes than there is room for.
fn few_pictures(at: &At<'_>, scene: &Scene) {
    let count = scene.stroke_pictures().len();
    if count > MAX_STROKE_PICTURES {
        let message = format!(
            "strokes are drawn with {count} pictures, but at most {MAX_STROKE_PICTURES} are allowed in a scene"
        );
        at.error("too-many", message, "let some strokes share a `texture`");
    }
}

fn cameras(at: &At<'_>, file: &SceneFile) -> Vec<Camera> {
    let files = file.camera.as_ref().map_or(&[][..], |cameras| cameras.as_slice());
    if files.is_empty() {
        let help = "add a [camera] with `eye` and `target`";
        at.error("no-camera", "the scene has no camera".into(), help);
    }
    unique_names(at, files.iter().map(|camera| camera.name.as_str()), "camera");
    files.iter().enumerate().map(|(i, file)| camera(&at.item(i), file)).collect()
}

fn camera(at: &At<'_>, file: &CameraFile) -> Camera {
    let sight = [0, 1, 2].map(|i| file.target[i] - file.eye[i]);
    let up = direction(&at.key("up"), file.up);
    if length(sight) < MIN_DIRECTION {
        let message = "`target` is where `eye` is, so the camera looks nowhere".to_owned();
        at.key("target").error("no-line-of-sight", message, "move one of them");
    } else if length(up) >= MIN_DIRECTION && length(cross(unit(sight), unit(up))) < MIN_UP_SINE {
        let message = "`up` runs along the line of sight from `eye` to `target`".to_owned();
        let help = "for a camera that looks straight down, write up = [0, 0, -1]";
        let at_up = at.key("up");
        (if at_up.exists() { at_up } else { at.key("target") }).error("up-along-sight", message, help);
    }
    Camera {
        name: file.name.clone(),
        eye: file.eye,
        target: file.target,
        up,
        fov_deg: file.fov,
        near: file.near,
    }
}

fn background(at: &At<'_>, file: Option<&BackgroundFile>) -> Background {
    let Some(file) = file else { return Background::Transparent };
    match file {
        BackgroundFile { colour: Some(one), gradient: None, image: None, paper: None } => {
            Background::Colour(colour(&at.key("colour"), one))
        }
        BackgroundFile { colour: None, gradient: Some([top, bottom]), image: None, paper: None } => {
            let at = at.key("gradient");
            Background::Gradient { top: colour(&at.item(0), top), bottom: colour(&at.item(1), bottom) }
        }
        BackgroundFile { colour: None, gradient: None, image: Some(path), paper: None } => {
            Background::Image(path.clone())
        }
        BackgroundFile { colour: None, gradient: None, image: None, paper: Some(paper) } => {
            Background::Paper(colour(&at.key("paper"), paper))
        }
        _ => {
            let message = "`background` must have exactly one of `colour`, `gradient`, `image` and `paper`";
            let help = "for a transparent background leave [background] out altogether";
            at.error("background-choice", message.into(), help);
            Background::Transparent
        }
    }
}

fn time(at: &At<'_>, file: &TimeFile) -> Time {
    let [first, last] = file.frames;
    if first > last {
        let message = format!("`frames` runs from {first} back to {last}");
        at.key("frames").error("falling-range", message, format!("write [{last}, {first}]"));
    }
    Time {
        fps: file.fps,
        frames: file.frames,
        hold: file.hold,
        substeps: file.substeps,
        pre_roll: file.pre_roll,
    }
}

fn unique_names<'n>(at: &At<'_>, names: impl Iterator<Item = &'n str>, what: &str) {
    let mut seen = HashSet::new();
    for (i, name) in names.enumerate() {
        let at = at.item(i).key("name");
        if name.is_empty() {
            at.error("empty-name", format!("the {what}'s name is empty"), "`--set` finds it by this name");
        }
        if !seen.insert(name) {
            let message = format!("two {what}s are named {name:?}");
            at.error("duplicate-name", message, "give each a `name` of its own");
        }
    }
}

pub(super) fn at_most(at: &At<'_>, what: &str, count: usize, most: usize, help: &str) {
    if count > most {
        let message = format!("there are {count} {what}s, but at most {most} are allowed");
        at.item(most).error("too-many", message, help);
    }
}
