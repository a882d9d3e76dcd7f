//! Surfaces, made of puffs that have their places, and room for their triangles.

use fumetto_scene::{EdgeKind, Ink, InkMethod, Matter, Object, Particle, Scene, Surface, SurfacePlan};

use super::{PlayedMatter, PlayedObject};
use crate::{
    Error,
    details::Details,
    gpu::Gpu,
    shapes::{
        mesh::Geometry,
        surface::{SurfaceObject, SurfaceScene},
        volume::MAX_LOBES,
    },
};

/// Makes room for a surface of an object's `matter` and for the lines that are drawn of it.
pub(super) fn add_surface(
    geometry: &mut Geometry,
    scene: &Scene,
    object: &Object,
    (surface, has_lines): (&Surface, bool),
    matter: &PlayedMatter,
) {
    match plan(scene, object, surface, matter) {
        Some(plan) => geometry.add_surface(plan.room.vertices, plan.room.triangles, has_lines),
        None => geometry.add_nothing(),
    }
}

/// Whether a surface has lines along its contours.
pub(super) fn has_contours(ink: &Ink) -> bool {
    ink.on && (ink.method == InkMethod::Vector || ink.stroke_of(EdgeKind::Silhouette).is_some())
}

/// What a surface of an object's `matter` is made with.
fn plan(scene: &Scene, object: &Object, surface: &Surface, matter: &PlayedMatter) -> Option<SurfacePlan> {
    match (matter, &object.matter) {
        (PlayedMatter::Still(particles), _) => Some(surface.plan(particles)),
        (PlayedMatter::Morph(tracks), _) => Some(surface.plan_morph(&tracks.sets())),
        (PlayedMatter::Sequence(_, particles), _) => Some(surface.plan_sequence(particles)),
        (PlayedMatter::Smoke(_), Matter::Smoke(smoke)) => {
            Some(surface.plan_smoke(smoke, scene.time.step_secs()))
        }
        (PlayedMatter::Imported(volume), _) if volume.is_sequence() => {
            let mut plan = surface.plan_sequence(&volume.balls);
            // Other files may be covered by more.
            plan.room.particles = MAX_LOBES;
            Some(plan)
        }
        (PlayedMatter::Imported(volume), _) => Some(surface.plan(&volume.balls)),
        _ => None,
    }
}

/// What never moves, of a surface that does not change either.
fn still<'a>(surface: &Surface, matter: &'a PlayedMatter) -> Option<&'a [Particle]> {
    match matter {
        PlayedMatter::Still(particles) if !surface.drifts() => Some(particles),
        PlayedMatter::Imported(volume) if !surface.drifts() && !volume.is_sequence() => Some(&volume.balls),
        _ => None,
    }
}

/// All surfaces, of puffs that have their places: those of the objects, then the layers of detail in them.
pub(super) fn surfaces(
    gpu: &Gpu,
    scene: &Scene,
    details: &Details,
    objects: &[PlayedObject],
) -> Result<SurfaceScene, Error> {
    let outer = (0..)
        .zip(&scene.objects)
        .filter_map(|(number, object)| Some((number, *object.shape.surface()?, 1.0)));
    let inner = details.layers().iter().map(|layer| (layer.object, layer.detail.surface, layer.detail.mass));
    let mut surfaces = Vec::new();
    for (number, surface, mass) in outer.chain(inner) {
        let (object, played) = (&scene.objects[number], &objects[number]);
        let Some(plan) = plan(scene, object, &surface, &played.matter) else { continue };
        let first = played.placement.first;
        let puffs = first..first + played.capacity;
        let still = still(&surface, &played.matter);
        let bricks = match &played.matter {
            PlayedMatter::Imported(volume) => Some(&volume.field),
            _ => None,
        };
        let scales = [surface.size / played.placement.size, mass];
        let surface = SurfaceObject { object: number, surface, scales, plan, puffs, still, bricks };
        surface.check(gpu).map_err(|source| Error::Surface { object: object.name.clone(), source })?;
        surfaces.push(surface);
    }
    Ok(SurfaceScene::new(gpu, &surfaces))
}
