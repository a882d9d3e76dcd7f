use super::puffs::puffs;
use super::{At, Styles, smoke::smoke};
use crate::file::{ObjectFile, ObjectKind, ParticlesFile};
use crate::limits::{MAX_PARTICLES, PARTICLE_BYTES};
use crate::{Matter, Object, Particle, Style};

/// A step of the simulation takes `step_secs`.
pub(super) fn object(
    at: &At<'_>,
    file: &ObjectFile,
    scene_style: &Style,
    step_secs: f64,
    styles: &mut Styles<'_>,
) -> Object {
    let style = match &file.style {
        Some(changes) => styles.changed(&at.key("style"), changes, scene_style),
        None => scene_style.clone(),
    };
    let object = Object {
        name: file.name.clone(),
        visible: file.visible,
        matter: matter(at, file),
        puffs: puffs(&at.key("shape").key("puffs"), file.shape.as_ref()),
        style,
        opacity: file.opacity,
    };
    let asked = object.capacity(step_secs).unwrap_or(0);
    if asked > MAX_PARTICLES {
        let bytes = asked.saturating_mul(PARTICLE_BYTES) / 1_000_000;
        let message = format!(
            "object {:?} may hold {asked} particles at once, but at most {MAX_PARTICLES} are allowed",
            file.name
        );
        let source = if file.kind == ObjectKind::Smoke { at.key("emitter") } else { at.key("particles") };
        let source = if source.exists() { source } else { *at };
        let help = format!(
            "they would take {bytes} MB; lower `count`, `rate` or `life`, and enlarge `radius` instead"
        );
        source.error("too-many-particles", message, help);
    }
    object
}

fn matter(at: &At<'_>, file: &ObjectFile) -> Matter {
    match file.kind {
        ObjectKind::Cloud => {
            belongs_to_smoke(&at.key("emitter"));
            belongs_to_smoke(&at.key("force"));
            cloud(at, file)
        }
        ObjectKind::Smoke => {
            let particles = at.key("particles");
            if particles.exists() {
                let message = "`particles` is no key of kind \"smoke\", whose particles come from emitters";
                particles.error(
                    "wrong-kind",
                    message.into(),
                    "write kind = \"cloud\", or an [[object.emitter]]",
                );
            }
            Matter::Smoke(smoke(at, file))
        }
    }
}

fn belongs_to_smoke(at: &At<'_>) {
    if at.exists() {
        let message = format!("`{}` is no key of kind \"cloud\", whose particles stand still", at.name());
        at.error("wrong-kind", message, "write kind = \"smoke\", or leave this out");
    }
}

fn cloud(at: &At<'_>, file: &ObjectFile) -> Matter {
    match &file.particles {
        None => {
            let message = format!("the cloud {:?} has no particles", file.name);
            at.key("particles").error("no-particles", message, PARTICLES_HELP);
            Matter::Still(Vec::new())
        }
        Some(ParticlesFile::List(list)) => {
            if list.is_empty() {
                let message = format!("the cloud {:?} has no particles", file.name);
                at.key("particles").warning("no-particles", message, PARTICLES_HELP);
            }
            let particle =
                |p: &crate::file::ParticleFile| Particle { center: p.center, radius: p.radius, mass: p.mass };
            Matter::Still(list.iter().map(particle).collect())
        }
        Some(ParticlesFile::Path(path)) => {
            let lower = path.to_lowercase();
            if !(lower.ends_with(".ply") || lower.ends_with(".csv")) {
                let message = format!("{path:?} is neither a .ply nor a .csv file");
                at.key("particles").error("unknown-format", message, "save the particles as PLY or CSV");
            }
            Matter::File(path.clone())
        }
    }
}

const PARTICLES_HELP: &str =
    "write particles = [{ center = [0, 1, 0], radius = 1.0 }], or the path of a .ply or .csv file";
