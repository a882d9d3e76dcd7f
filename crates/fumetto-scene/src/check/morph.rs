use super::At;
use crate::file::{EaseFile, MorphFile, ParticleFile, ParticlesFile};
use crate::{Ease, Given, Metamorphosis, Morph, Particle};

const PARTICLES_HELP: &str =
    "write particles = [{ center = [0, 1, 0], radius = 1.0 }], or the path of a .ply or .csv file";

/// A cloud that changes.
pub(super) fn metamorphosis(at: &At<'_>, start: Given, files: &[MorphFile]) -> Metamorphosis {
    if let Given::File(path) = &start {
        refuse_sequence(&at.key("particles"), path);
    }
    let at = at.key("morph");
    let mut free_from = 0.0;
    let change = |(index, file): (usize, &MorphFile)| {
        let at = at.item(index);
        let [from, until] = file.during;
        if from >= until {
            let message = format!("the change `during` runs from {from} s to {until} s");
            at.key("during").error("falling-range", message, "write the earlier moment first, as in [1, 3]");
        } else if from < free_from {
            let message =
                format!("this change begins at {from} s, before the one ahead of it ends at {free_from} s");
            at.key("during").error(
                "morphs-overlap",
                message,
                "list changes by time, and end one before the next",
            );
        }
        free_from = until;
        let particles = given(&at.key("particles"), Some(&file.particles), "this change");
        if let Given::File(path) = &particles {
            refuse_sequence(&at.key("particles"), path);
        }
        Morph { during_secs: file.during, particles, ease: ease(file.ease) }
    };
    let changes = files.iter().enumerate().map(change).collect();
    Metamorphosis { start, changes }
}

/// `####` and `{}` number the files of a sequence, as in `fumetto-formats`.
pub(super) fn is_sequence(path: &str) -> bool {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    name.contains('#') || name.contains("{}")
}

fn refuse_sequence(at: &At<'_>, path: &str) {
    if is_sequence(path) {
        let message =
            format!("{path:?} is a sequence, and a cloud that changes has one file for each of its shapes");
        at.error("morph-of-sequence", message, "name one file, or leave `morph` out");
    }
}

fn ease(file: EaseFile) -> Ease {
    match file {
        EaseFile::InOut => Ease::InOut,
        EaseFile::In => Ease::In,
        EaseFile::Out => Ease::Out,
        EaseFile::Linear => Ease::Linear,
    }
}

/// Particles that are listed or named; `whose` is for messages.
pub(super) fn given(at: &At<'_>, file: Option<&ParticlesFile>, whose: &str) -> Given {
    match file {
        None => {
            at.error("no-particles", format!("{whose} has no particles"), PARTICLES_HELP);
            Given::Listed(Vec::new())
        }
        Some(ParticlesFile::List(list)) => {
            if list.is_empty() {
                at.warning("no-particles", format!("{whose} has no particles"), PARTICLES_HELP);
            }
            let particle = |p: &ParticleFile| Particle { center: p.center, radius: p.radius, mass: p.mass };
            Given::Listed(list.iter().map(particle).collect())
        }
        Some(ParticlesFile::Path(path)) => {
            let lower = path.to_lowercase();
            if !(lower.ends_with(".ply") || lower.ends_with(".csv")) {
                let message = format!("{path:?} is neither a .ply nor a .csv file");
                at.error("unknown-format", message, "save the particles as PLY or CSV");
            }
            Given::File(path.clone())
        }
    }
}
