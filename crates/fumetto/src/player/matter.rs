//! What the objects of a scene are made of, as it is played.

use std::ops::Range;

use fumetto_formats::{Model, ModelOptions, is_sequence, sequence_path};
use fumetto_scene::{Given, Matter, Mesh, Object, Particle, Scene};

use crate::{
    Assets, Error,
    assets::{load_model, load_particles},
    gpu::Gpu,
    morph::Tracks,
    particles::Plume,
    shapes::{
        mesh::Geometry,
        puffs::Placement,
        surface::{is_outside, peak_of_nothing},
        volume::MAX_LOBES,
    },
};

use super::imported::PlayedVolume;

/// One object as it is played.
pub(crate) struct PlayedObject {
    pub(crate) matter: PlayedMatter,
    pub(crate) placement: Placement,
    /// Room for this many puffs.
    pub(super) capacity: u32,
}

pub(crate) enum PlayedMatter {
    Still(Vec<Particle>),
    /// A numbered sequence of particle files, and the particles of the frame that is shown.
    Sequence(String, Vec<Particle>),
    /// Particles that become others.
    Morph(Box<Tracks>),
    Smoke(Box<Plume>),
    Model(Box<PlayedModel>),
    /// A volume out of a file.
    Imported(Box<PlayedVolume>),
    /// It is played with all other paint.
    Paint,
}

/// A model with its copies, and which parts of the scene's geometry they are.
pub(crate) struct PlayedModel {
    pub(super) mesh: Mesh,
    pub(crate) model: Model,
    pub(crate) parts: Range<usize>,
}

impl PlayedMatter {
    pub(super) fn count(&self) -> u64 {
        match self {
            Self::Still(particles) | Self::Sequence(_, particles) => particles.len() as u64,
            Self::Morph(tracks) => tracks.slots() as u64,
            Self::Smoke(plume) => plume.emissions.iter().map(|emission| u64::from(emission.capacity())).sum(),
            Self::Model(_) | Self::Paint => 0,
            Self::Imported(_) => MAX_LOBES.into(),
        }
    }

    pub(super) fn is_model(&self) -> bool {
        matches!(self, Self::Model(_))
    }
}

pub(super) fn seed_of(scene: &Scene, index: u32) -> u32 {
    scene.seed.wrapping_mul(0x85eb_ca6b).wrapping_add(index.wrapping_mul(0xc2b2_ae35))
}

/// `scales` of relief are exaggerated.
pub(super) fn play_mesh(
    mesh: &Mesh,
    scales: u32,
    assets: &dyn Assets,
    geometry: &mut Geometry,
    notes: &mut Vec<String>,
) -> Result<PlayedMatter, Error> {
    let model = load_model(assets, &mesh.model, ModelOptions { smooth_degrees: mesh.smooth_deg })?;
    notes.extend(model.notes.iter().cloned());
    let parts = geometry.add(mesh, &model);
    if scales > 0 {
        geometry.smooth(&parts, scales);
    }
    Ok(PlayedMatter::Model(Box::new(PlayedModel { mesh: mesh.clone(), model, parts })))
}

pub(super) fn play_matter(
    gpu: &Gpu,
    scene: &Scene,
    object: &Object,
    index: u32,
    assets: &dyn Assets,
    first_frame: u32,
    notes: &mut Vec<String>,
) -> Result<PlayedMatter, Error> {
    Ok(match &object.matter {
        Matter::Still(particles) => PlayedMatter::Still(particles.clone()),
        Matter::File(path) => {
            let table = load_particles(assets, &sequence_path(path, first_frame))?;
            notes.extend(table.notes);
            if is_sequence(path) {
                PlayedMatter::Sequence(path.clone(), table.particles)
            } else {
                PlayedMatter::Still(table.particles)
            }
        }
        Matter::Morph(morph) => {
            let mut sets = Vec::with_capacity(morph.changes.len() + 1);
            for given in morph.all() {
                sets.push(match given {
                    Given::Listed(particles) => particles.clone(),
                    Given::File(path) => {
                        let table = load_particles(assets, path)?;
                        notes.extend(table.notes);
                        table.particles
                    }
                });
            }
            PlayedMatter::Morph(Box::new(Tracks::new(morph, sets)))
        }
        Matter::Smoke(smoke) => {
            let seed = seed_of(scene, index);
            notes.extend(note_on_sub_steps(object, scene.time.step_secs()));
            let (step_secs, obstacles) = (scene.time.step_secs(), scene.has_obstacles());
            PlayedMatter::Smoke(Box::new(Plume::new(gpu, smoke, seed, step_secs, obstacles)))
        }
        Matter::Imported(imported) => {
            let volume = PlayedVolume::new(gpu, assets, imported, first_frame, &object.shape, notes)?;
            PlayedMatter::Imported(Box::new(volume))
        }
        Matter::Paint(_) => PlayedMatter::Paint,
        Matter::Mesh(_) => unreachable!("models are played with the scene's geometry"),
    })
}

/// Says so where air is too quick for its cells to be moved at once.
fn note_on_sub_steps(object: &Object, step_secs: f64) -> Option<String> {
    let plan = object.grid_plan(step_secs).filter(|plan| plan.sub_steps > 1)?;
    let (steps, side) = (plan.sub_steps, plan.side);
    Some(format!(
        "the air of `{}` moves in {steps} sub-steps a step: its cells are {side:.3} m wide",
        object.name
    ))
}

/// Says so where a cloud or a volume is too thin for its surface.
pub(super) fn note_on_nothing(object: &Object, matter: &PlayedMatter) -> Option<String> {
    let surface = object.shape.surface()?;
    let (what, peak) = match matter {
        PlayedMatter::Still(particles) => ("particles are", peak_of_nothing(surface, particles)?),
        PlayedMatter::Imported(volume) if !volume.is_sequence() && is_outside(surface, volume.peak) => {
            ("voxels are", volume.peak)
        }
        _ => return None,
    };
    Some(format!(
        "the surface of `{}` is empty: its {what} at most about {peak} dense, and its `threshold` is {}",
        object.name, surface.threshold
    ))
}
