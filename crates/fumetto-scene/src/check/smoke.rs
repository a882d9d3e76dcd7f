use super::At;
use super::grid::{grid, source};
use super::values::{curve, direction, range};
use super::vortex::{rings, vortex};
use crate::file::{EmitterFile, EmitterShapeFile, ForceFile, ObjectFile, SolverFile};
use crate::limits::{FACTOR, LENGTH, LIFE_SECS, MASS, SECONDS, SHARE};
use crate::{Burst, Emitter, EmitterShape, Force, Smoke};

pub(super) fn smoke(at: &At<'_>, file: &ObjectFile) -> Smoke {
    let emitters = file.emitter.as_ref().map_or(&[][..], |emitters| emitters.as_slice());
    let forces = file.force.as_deref().unwrap_or_default();
    if emitters.is_empty() {
        let message = format!("the smoke {:?} has no emitter, so it has no particles", file.name);
        let help = "add an [[object.emitter]] with a `shape` and a `rate`";
        at.key("emitter").error("no-emitter", message, help);
    }
    if file.solver != Some(SolverFile::Grid) {
        still_air(at, forces);
    }
    let vortex = vortex(at, file);
    let at_item = |key, i| at.key(key).item(i);
    Smoke {
        emitters: emitters.iter().enumerate().map(|(i, one)| emitter(&at_item("emitter", i), one)).collect(),
        forces: forces.iter().enumerate().map(|(i, one)| force(&at_item("force", i), one)).collect(),
        vortex,
        grid: grid(at, file),
    }
}

fn emitter(at: &At<'_>, file: &EmitterFile) -> Emitter {
    births(at, file);
    let growth = |key, file| curve(&at.key(key), file, &FACTOR, "this multiplies the value at birth");
    let share = |key, file| curve(&at.key(key), file, &SHARE, "this is a share, from 0 to 1");
    Emitter {
        shape: shape(&at.key("shape"), file.shape),
        rate: file.rate,
        bursts: file.bursts.iter().map(|burst| Burst { at: burst.at, count: burst.count }).collect(),
        count: file.count,
        active: active(&at.key("active"), file.active),
        velocity: file.velocity,
        spread_deg: file.spread,
        speed_jitter: file.speed_jitter,
        life: range(&at.key("life"), file.life, &LIFE_SECS, "this is in seconds"),
        radius: range(&at.key("radius"), file.radius, &LENGTH, "this is in metres"),
        mass: range(&at.key("mass"), file.mass, &MASS, "mass is relative to other particles'; 1 is usual"),
        radius_over_life: growth("radius_over_life", &file.radius_over_life),
        mass_over_life: growth("mass_over_life", &file.mass_over_life),
        erosion_over_life: share("erosion_over_life", &file.erosion_over_life),
        opacity_over_life: share("opacity_over_life", &file.opacity_over_life),
        rings: rings(&at.key("rings"), file.rings.as_ref()),
        source: source(file.source.as_ref()),
    }
}

/// Moving air takes particles along by drag alone.
fn still_air(at: &At<'_>, forces: &[ForceFile]) {
    let moves_air = |force: &ForceFile| {
        matches!(force, ForceFile::Wind { .. } | ForceFile::Turbulence { .. } | ForceFile::Vortex { .. })
    };
    let drags = |force: &ForceFile| matches!(force, ForceFile::Drag { .. });
    if let Some(index) = forces.iter().position(moves_air)
        && !forces.iter().any(drags)
    {
        let message = "nothing feels this moving air: the object has no drag".into();
        let help = "add an [[object.force]] of kind = \"drag\"; rate = 2 is usual for smoke";
        at.key("force").item(index).warning("no-drag", message, help);
    }
}

/// Whether something is born at all, and by one rule only.
fn births(at: &At<'_>, file: &EmitterFile) {
    let bursts: u64 = file.bursts.iter().map(|burst| u64::from(burst.count)).sum();
    if file.count.is_some() {
        for key in ["rate", "bursts"] {
            let unused = at.key(key);
            if unused.exists() {
                let message = format!("`{key}` does nothing beside `count`, which keeps a number alive");
                unused.warning("unused-key", message, format!("leave out `{key}` or `count`"));
            }
        }
    }
    if file.count.unwrap_or(0) == 0 && (file.count.is_some() || file.rate == 0.0 && bursts == 0) {
        let help = "give a `rate` (a second), `bursts` (at moments) or a `count` (kept alive)";
        at.warning("no-births", "this emitter never emits a particle".into(), help);
    }
}

/// Always, unless the file says from when until when.
fn active(at: &At<'_>, file: Option<[f32; 2]>) -> [f32; 2] {
    let Some([from, until]) = file else { return [0.0, f32::MAX] };
    at.item(0).within(from, &SECONDS, "this is in seconds from the beginning of the simulation");
    at.item(1).within(until, &SECONDS, "this is in seconds from the beginning of the simulation");
    if from > until {
        let message = format!("`active` runs from {from} s back to {until} s");
        at.error("falling-range", message, format!("write [{until}, {from}]"));
    }
    [from, until]
}

fn shape(at: &At<'_>, file: EmitterShapeFile) -> EmitterShape {
    match file {
        EmitterShapeFile::Point { center } => EmitterShape::Point { center },
        EmitterShapeFile::Disc { center, normal, radius, hole } => {
            let normal = direction(&at.key("disc").key("normal"), normal);
            EmitterShape::Disc { center, normal, radius, hole }
        }
        EmitterShapeFile::Sphere { center, radius } => EmitterShape::Sphere { center, radius },
        EmitterShapeFile::Box { center, size } => EmitterShape::Box { center, size },
        EmitterShapeFile::Line { from, to } => EmitterShape::Line { from, to },
    }
}

fn force(at: &At<'_>, file: &ForceFile) -> Force {
    match *file {
        ForceFile::Gravity { acceleration } => Force::Gravity { acceleration },
        ForceFile::Buoyancy { acceleration, cooling } => Force::Buoyancy { acceleration, cooling },
        ForceFile::Drag { rate } => Force::Drag { rate },
        ForceFile::Wind { velocity, gust, gust_secs } => Force::Wind { velocity, gust, gust_secs },
        ForceFile::Turbulence { speed, scale, octaves, drift } => {
            Force::Turbulence { speed, scale, octaves, drift }
        }
        ForceFile::Vortex { center, axis, radius, speed } => {
            Force::Vortex { center, axis: direction(&at.key("axis"), axis), radius, speed }
        }
        ForceFile::Attract { center, radius, acceleration } => {
            Force::Attract { center, radius, acceleration }
        }
    }
}
