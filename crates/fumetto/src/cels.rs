//! Which objects are drawn together.

use fumetto_scene::{LightKind, Matter, Object, Scene, Shading, Style};
use glam::Vec3;

use crate::tone::MAX_OBJECTS;

/// Objects that are drawn into layers of their own, like an animator's cel.
pub(crate) struct Cel {
    /// Numbers of the scene's objects.
    pub(crate) members: Vec<usize>,
    /// Whether its puffs are copies of pre-shaded sprites.
    pub(crate) pre_shaded: bool,
}

/// Opaque objects share the first cel; every object that light goes through has its own, the farthest
/// first.
pub(crate) fn cels(scene: &Scene, eye: Vec3) -> Vec<Cel> {
    let objects = &scene.objects;
    let (mut opaque, mut clear) = (Vec::new(), Vec::new());
    for (index, object) in objects.iter().enumerate().filter(|(_, object)| is_drawn(object)) {
        if is_opaque(object) { opaque.push(index) } else { clear.push(index) }
    }
    clear.sort_by(|&a, &b| {
        let distance = |index: usize| anchor(&objects[index]).distance(eye);
        distance(b).total_cmp(&distance(a))
    });
    let cel = |members: Vec<usize>| Cel { pre_shaded: is_pre_shaded(scene, &members), members };
    std::iter::once(opaque).chain(clear.into_iter().map(|index| vec![index])).map(cel).collect()
}

/// Paint only shows in how all else is drawn.
fn is_drawn(object: &Object) -> bool {
    object.visible && !matches!(object.matter, Matter::Paint(_))
}

/// Sprites are shaded once for all puffs only in light that is the same for all.
fn is_pre_shaded(scene: &Scene, members: &[usize]) -> bool {
    let only_suns = scene.lights.iter().all(|light| matches!(light.kind, LightKind::Sun { .. }));
    let chosen = |&member: &usize| {
        let object = &scene.objects[member];
        let has_puffs = !matches!(object.matter, Matter::Mesh(_)) && object.shape.puffs().is_some();
        // Of paint, each look is drawn from the same cel.
        has_puffs && scene.styles_of(member).all(wants_sprites)
    };
    only_suns && scene.objects.len() <= MAX_OBJECTS && !members.is_empty() && members.iter().all(chosen)
}

fn wants_sprites(style: &Style) -> bool {
    let is_chosen = match style.shading {
        Shading::PreShaded => true,
        Shading::PerPixel => false,
        // Then the two look alike, and copying is the faster.
        Shading::Auto => style.form == 0.0 && style.clean_px == 0.0,
    };
    is_chosen && style.suits_sprites()
}

fn is_opaque(object: &Object) -> bool {
    let fades = match &object.matter {
        // What fades from sight has ever less hold on a surface, which itself stays opaque.
        Matter::Smoke(_) if object.shape.surface().is_some() => false,
        // Of a volume the style's tones are opaque, however much light comes through it.
        Matter::Smoke(_) if object.shape.volume().is_some() => false,
        Matter::Smoke(smoke) => smoke
            .emitters
            .iter()
            .any(|emitter| emitter.opacity_over_life.points.iter().any(|&[_, opacity]| opacity < 1.0)),
        Matter::Still(_)
        | Matter::File(_)
        | Matter::Morph(_)
        | Matter::Mesh(_)
        | Matter::Imported(_)
        | Matter::Paint(_) => false,
    };
    let is_soft = object.shape.volume().is_some_and(|volume| volume.soft > 0.0);
    object.opacity >= 1.0 && !fades && !is_soft
}

/// Where an object roughly is, to order cels by.
fn anchor(object: &Object) -> Vec3 {
    use fumetto_scene::EmitterShape as Shape;
    let mean = |places: &mut dyn Iterator<Item = Vec3>| {
        let (sum, count) = places.fold((Vec3::ZERO, 0.0), |(sum, count), place| (sum + place, count + 1.0));
        sum / f32::max(count, 1.0)
    };
    match &object.matter {
        Matter::Still(particles) => mean(&mut particles.iter().map(|particle| particle.center.into())),
        Matter::Morph(morph) => {
            let listed = morph.start.listed().unwrap_or_default();
            mean(&mut listed.iter().map(|particle| particle.center.into()))
        }
        Matter::File(_) | Matter::Paint(_) => Vec3::ZERO,
        Matter::Imported(imported) => imported.place.position.into(),
        Matter::Mesh(mesh) => mean(&mut mesh.copies.iter().map(|copy| copy.position.into())),
        Matter::Smoke(smoke) => mean(&mut smoke.emitters.iter().map(|emitter| match emitter.shape {
            Shape::Point { center }
            | Shape::Disc { center, .. }
            | Shape::Sphere { center, .. }
            | Shape::Box { center, .. } => center.into(),
            Shape::Line { from, to } => 0.5 * (Vec3::from(from) + Vec3::from(to)),
        })),
    }
}
