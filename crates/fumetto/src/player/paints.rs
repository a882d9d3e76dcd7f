//! What there is to say about paint before any falls.

use fumetto_scene::{Paint, Scene};
use glam::Vec3;

use super::{PlayedMatter, PlayedObject};
use crate::{paint::PaintScene, shapes::mesh::Geometry};

/// Says so where paint has nothing to fall on.
pub(super) fn notes_on_paint(
    scene: &Scene,
    objects: &[PlayedObject],
    geometry: &Geometry,
    paints: &PaintScene,
) -> Vec<String> {
    let mut notes = Vec::new();
    let grids = scene.paints().filter(|(_, paint)| paint.cells.is_some());
    for ((index, _), has_floor) in grids.zip(paints.have_floors()) {
        if !has_floor {
            notes.push(format!(
                "no model lies in the box of the `cells` of `{}`, so nothing holds what is poured",
                scene.objects[index].name
            ));
        }
    }
    let Some([low, high]) = bounds(scene, objects, geometry) else { return notes };
    for (index, paint) in scene.paints() {
        let away =
            balls(paint).filter(|(center, radius)| center.clamp(low, high).distance(*center) > *radius);
        let (away, all) = (away.count(), balls(paint).count());
        if away > 0 {
            let name = &scene.objects[index].name;
            notes.push(format!(
                "{away} of the {all} drops and strokes of `{name}` never reach anything that is drawn"
            ));
        }
    }
    notes
}

/// The farthest that each drop and stroke reaches, as a ball.
fn balls(paint: &Paint) -> impl Iterator<Item = (Vec3, f32)> {
    // Grain adds up to its share of the radius.
    let widest = 1.0 + paint.spread.grain;
    let drops = paint
        .drops
        .iter()
        .map(move |drop| (Vec3::from(drop.at), widest * drop.radius.largest().max(drop.start_m)));
    let strokes = paint.strokes.iter().map(move |stroke| {
        let places = || stroke.path.iter().copied().map(Vec3::from);
        let low = places().fold(Vec3::INFINITY, Vec3::min);
        let high = places().fold(Vec3::NEG_INFINITY, Vec3::max);
        let radius = widest * stroke.radius.largest().max(stroke.start_m);
        (0.5 * (low + high), 0.5 * low.distance(high) + radius)
    });
    // Paint that runs may come from anywhere above.
    let runs = Vec3::from(paint.spread.gravity) != Vec3::ZERO;
    drops.chain(strokes).filter(move |_| !runs)
}

/// The box around all that is drawn, where it can be told: what moves may go anywhere.
fn bounds(scene: &Scene, objects: &[PlayedObject], geometry: &Geometry) -> Option<[Vec3; 2]> {
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let mut add = |place: Vec3, radius: f32| {
        low = low.min(place - radius);
        high = high.max(place + radius);
    };
    for (object, played) in scene.objects.iter().zip(objects) {
        match &played.matter {
            PlayedMatter::Still(particles) => {
                for particle in particles {
                    add(particle.center.into(), particle.radius * object.shape.size());
                }
            }
            PlayedMatter::Model(played) if !played.model.is_animated() => {}
            PlayedMatter::Paint => {}
            PlayedMatter::Sequence(..)
            | PlayedMatter::Morph(_)
            | PlayedMatter::Smoke(_)
            | PlayedMatter::Imported(_)
            | PlayedMatter::Model(_) => return None,
        }
    }
    for source in &geometry.sources {
        let world_from_part = geometry.parts[source.part as usize].world_from_part;
        add(world_from_part.transform_point3(source.position.into()), 0.0);
    }
    (low.x <= high.x).then_some([low, high])
}
