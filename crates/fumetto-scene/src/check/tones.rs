use super::At;
use super::values::{colour, hex_colour};
use crate::file::{StepsFile, ToneFile, TonesFile};
use crate::limits::MAX_TONES;
use crate::{Colour, Tone};

/// Tones in rising order.
pub(super) fn tones(at: &At<'_>, file: &TonesFile) -> Vec<Tone> {
    match file {
        TonesFile::List(files) => list(at, files),
        TonesFile::Steps(file) => steps(at, file),
    }
}

/// From `dark` to `light`, mixed in linear light, where each takes as much of the light.
fn steps(at: &At<'_>, file: &StepsFile) -> Vec<Tone> {
    let dark = colour(&at.key("dark"), &file.dark).linear;
    let light = colour(&at.key("light"), &file.light).linear;
    let tone = |step: u32| {
        let share = step as f32 / (file.steps - 1).max(1) as f32;
        // So written, both ends come out exactly.
        let mix = |channel: usize| dark[channel] * (1.0 - share) + light[channel] * share;
        Tone { colour: Colour { linear: [mix(0), mix(1), mix(2)] }, from: step as f32 / file.steps as f32 }
    };
    (0..file.steps).map(tone).collect()
}

/// Where no tone says where it begins, they share the light evenly.
fn list(at: &At<'_>, files: &[ToneFile]) -> Vec<Tone> {
    let count = files.len();
    if count == 0 || count > MAX_TONES {
        let message = format!("`tones` must have from 1 to {MAX_TONES} colours, not {count}");
        at.error("tone-count", message, "for a smooth ramp use an image: ramp = \"ramp.png\"");
    }
    let placed = files.iter().filter(|file| matches!(file, ToneFile::Placed(_))).count();
    if placed != 0 && placed != count {
        let message = "some of `tones` say from which light they are drawn and some do not".to_owned();
        at.error("mixed-tones", message, "give `from` to all, or to none to space them evenly");
    }
    let mut tones: Vec<Tone> = Vec::with_capacity(count);
    for (i, file) in files.iter().enumerate() {
        let at = at.item(i);
        let tone = match file {
            ToneFile::Hex(hex) => Tone { colour: hex_colour(&at, hex), from: i as f32 / count as f32 },
            ToneFile::Linear(linear) => {
                Tone { colour: Colour { linear: *linear }, from: i as f32 / count as f32 }
            }
            ToneFile::Placed(tone) => {
                Tone { colour: colour(&at.key("colour"), &tone.colour), from: tone.from }
            }
        };
        if placed == count {
            follows(&at.key("from"), tones.last(), tone.from);
        }
        tones.push(tone);
    }
    tones
}

/// Whether a tone may begin at `from` after `last`.
fn follows(at: &At<'_>, last: Option<&Tone>, from: f32) {
    match last {
        None if from != 0.0 => {
            let message = format!("the darkest tone must begin at 0, not {from}");
            at.error("tones-not-rising", message, "whatever gets less light would have no colour");
        }
        Some(last) if from <= last.from => {
            let message = format!("this tone begins at {from}, and the one before it at {}", last.from);
            at.error("tones-not-rising", message, "order tones from dark to light, with rising `from`");
        }
        _ => {}
    }
}
