//! Models that smoke goes round.

use fumetto_scene::{GridPlan, Matter, Scene, Smoke};
use glam::Vec3;

use super::{PlayedMatter, PlayedModel, PlayedObject};
use crate::{
    Error, TooManyFacets,
    gpu::Frame,
    particles::{Facet, Plume, Voxels},
    shapes::mesh::triangles_at,
};

pub(super) fn obstacles(objects: &[PlayedObject]) -> impl Iterator<Item = &PlayedModel> {
    objects.iter().filter_map(|object| match &object.matter {
        PlayedMatter::Model(played) if played.mesh.obstacle => Some(&**played),
        _ => None,
    })
}

/// The moments between which a model's movement says how fast it moves for `dt` from `time` on: within one turn of its
/// animations, since between their last moment and their first it may be anywhere else.
fn moving(duration: f64, (time, dt): (f64, f64)) -> [f64; 2] {
    let begin = time.rem_euclid(duration);
    // The last moment itself is the next turn's first.
    let last = f64::from((duration as f32).next_down());
    if !begin.is_finite() || begin + dt <= last {
        return [time, time + dt];
    }
    [(last - dt).max(0.0), last]
}

/// All of them in the cells of a grid, as they are at `time` and move until `dt` later.
fn voxels(
    objects: &[PlayedObject],
    plan: &GridPlan,
    (time, dt): (f64, f64),
) -> Result<Voxels, TooManyFacets> {
    let mut facets = Vec::new();
    for PlayedModel { mesh, model, .. } in obstacles(objects) {
        let at = |time: f64| triangles_at(mesh, model, time as f32);
        let [from, to] = moving(model.duration_secs().into(), (time, dt));
        let secs = (to - from) as f32;
        facets.extend(at(time).into_iter().zip(at(from).into_iter().zip(at(to))).map(
            |(corners, (before, after))| {
                let shift = after.iter().sum::<Vec3>() - before.iter().sum::<Vec3>();
                Facet { corners, velocity: shift / (3.0 * secs) }
            },
        ));
    }
    Voxels::new(plan, &facets)
}

/// Puts obstacles to where they are in the step that begins at `time`, if they have moved since the last.
pub(super) fn place(
    frame: &mut Frame<'_>,
    objects: &[PlayedObject],
    plume: &Plume,
    is_first: bool,
    (time, dt): (f64, f64),
) {
    let Some(air) = plume.air().filter(|air| air.solids.are_there) else { return };
    if is_first || obstacles(objects).any(|played| played.model.is_animated()) {
        // At the start they were few enough; should they ever grow, they stay as they were.
        if let Ok(voxels) = voxels(objects, &air.plan, (time, dt)) {
            // The steps before have what was there before; and what is written waits for one step only.
            frame.flush("particles.obstacles");
            air.solids.set(frame.gpu, &voxels);
        }
    }
}

/// Refuses obstacles that are too many, and tells of what they may spoil.
pub(super) fn check(scene: &Scene, objects: &[PlayedObject]) -> Result<Vec<String>, Error> {
    let mut notes = Vec::new();
    for (object, played) in scene.objects.iter().zip(objects) {
        let (PlayedMatter::Smoke(plume), Matter::Smoke(smoke)) = (&played.matter, &object.matter) else {
            continue;
        };
        let Some(air) = plume.air().filter(|air| air.solids.are_there) else { continue };
        let voxels = voxels(objects, &air.plan, (0.0, scene.time.step_secs()))
            .map_err(|source| Error::Obstacles { object: object.name.clone(), source })?;
        notes.extend(notes_on(&object.name, smoke, &voxels, |place| air.in_cells(place)));
    }
    Ok(notes)
}

fn notes_on(name: &str, smoke: &Smoke, voxels: &Voxels, in_cells: impl Fn([f32; 3]) -> Vec3) -> Vec<String> {
    let mut notes = Vec::new();
    if voxels.leaks {
        notes.push(format!(
            "an obstacle in the air of `{name}` is not closed: cells beside its holes are left as air"
        ));
    }
    for (emitter, number) in smoke.emitters.iter().zip(1..) {
        if voxels.holds(in_cells(emitter.shape.middle())) {
            notes.push(format!(
                "the middle of emitter {number} of `{name}` lies inside an obstacle: its smoke is pushed out"
            ));
        }
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_of_animations_is_not_left() {
        assert_eq!(moving(2.0, (0.5, 0.25)), [0.5, 0.75]);
        assert_eq!(moving(2.0, (4.5, 0.25)), [4.5, 4.75]);
        let [from, to] = moving(2.0, (5.875, 0.25));
        assert!((from - 1.75).abs() < 1e-6 && (to - 2.0).abs() < 1e-6 && to < 2.0, "{from} to {to}");
        let [from, to] = moving(0.1, (0.0, 0.25));
        assert!(from == 0.0 && to < 0.1 && to > 0.09, "shorter than a step: {from} to {to}");
        assert_eq!(moving(0.0, (1.0, 0.25)), [1.0, 1.25], "nothing moves");
    }
}
