use super::At;
use crate::file::{ObjectFile, RingsFile, SolverFile};
use crate::limits::MAX_VORTICES;
use crate::{Object, Rings, Vortex, vortex_bytes};

/// What makes smoke curl, unless the file wants another solver.
pub(super) fn vortex(at: &At<'_>, file: &ObjectFile) -> Option<Vortex> {
    let emitters = file.emitter.as_ref().map_or(&[][..], |emitters| emitters.as_slice());
    if let Some(solver @ (SolverFile::Forces | SolverFile::Grid)) = file.solver {
        let name = if solver == SolverFile::Grid { "grid" } else { "forces" };
        let rings = (0..emitters.len()).map(|index| at.key("emitter").item(index).key("rings"));
        for unused in std::iter::once(at.key("vortex")).chain(rings).filter(At::exists) {
            let message = format!("`{}` does nothing beside solver = {name:?}", unused.name());
            unused.warning("unused-key", message, "leave it out, or write solver = \"vortex\"");
        }
        return None;
    }
    let file = file.vortex.unwrap_or_default();
    Some(Vortex {
        strength: file.strength,
        buoyancy: file.buoyancy,
        core: file.core,
        viscosity: file.viscosity,
        decay: file.decay,
        segments: file.segments,
        error: file.error,
    })
}

pub(super) fn rings(at: &At<'_>, file: Option<&RingsFile>) -> Option<Rings> {
    let file = file?;
    if file.rate == 0.0 && file.at.is_empty() {
        let help = "give a `rate` (a second) or moments, as in at = [0.5, 2]; without `rings` the emitter sheds \
                    rings of itself";
        at.warning("no-rings", "these rings never come".into(), help);
    }
    Some(Rings {
        circulation: file.circulation,
        rate: file.rate,
        at: file.at.clone(),
        radius: file.radius,
        wobble: file.wobble,
    })
}

/// Refuses more vortices than their tree has room for.
pub(super) fn few_vortices(at: &At<'_>, object: &Object, step_secs: f64) {
    let asked = object.vortices(step_secs);
    if asked > MAX_VORTICES {
        let bytes = vortex_bytes(asked) / 1_000_000;
        let message = format!(
            "object {:?} may hold {asked} vortices at once, but at most {MAX_VORTICES} are allowed",
            object.name
        );
        let help = format!(
            "they would take {bytes} MB; lower the `rate` of `rings`, the emitter's `life`, or `segments` of \
             `vortex`"
        );
        at.key("emitter").error("too-many-vortices", message, help);
    }
}
