//! Room for the particles of all objects, and how these look as puffs.

use fumetto_scene::{Matter, Puffs, Scene, Shape};

use super::PlayedObject;
use crate::{
    Error,
    gpu::Gpu,
    object::ObjectStyle,
    shapes::puffs::{Atlas, PuffObject, PuffScene},
};

/// Bytes of the largest record that there is one of for each particle.
const RECORD_BYTES: u64 = 64;

/// Refuses a scene whose particles would not fit, before anything is allocated.
pub(super) fn check_room(gpu: &Gpu, scene: &Scene) -> Result<(), Error> {
    let asked = scene.requirements().iter().filter_map(|cost| cost.particles).sum();
    let allowed = gpu.device.limits().max_storage_buffer_binding_size / RECORD_BYTES;
    if asked > allowed { Err(Error::TooMany { asked, allowed }) } else { Ok(()) }
}

/// The atlas of all objects' puffs, and where in it each object's variants begin.
pub(super) fn atlas(gpu: &Gpu, scene: &Scene) -> Result<(Vec<u32>, Atlas), Error> {
    let mut kinds: Vec<Puffs> = Vec::new();
    let mut firsts = Vec::with_capacity(scene.objects.len());
    for object in &scene.objects {
        let is_thing = matches!(object.matter, Matter::Mesh(_) | Matter::Paint(_));
        let (Shape::Puffs(puffs), false) = (&object.shape, is_thing) else {
            firsts.push(0);
            continue;
        };
        let puffs = Puffs { size: 1.0, ..*puffs };
        let known = kinds.iter().position(|kind| *kind == puffs).unwrap_or_else(|| {
            kinds.push(puffs);
            kinds.len() - 1
        });
        firsts.push(kinds[..known].iter().map(|kind| kind.variants).sum());
    }
    Ok((firsts, Atlas::new(gpu, &kinds)?))
}

/// How many kinds of puffs an object's particles choose from: bundles of balls, or colours. Particles of a surface
/// are never drawn singly.
pub(super) fn variants_of(shape: &Shape) -> u32 {
    match shape {
        Shape::Puffs(puffs) => puffs.variants,
        Shape::Volume(volume) => volume.colours.len().max(1) as u32,
        Shape::Surface(_) => 1,
    }
}

/// Gives every object its place in the list of puffs.
pub(super) fn place(
    gpu: &Gpu,
    scene: &Scene,
    objects: &mut [PlayedObject],
    atlas: Atlas,
) -> Result<PuffScene, Error> {
    let asked = objects.iter().map(|object| u64::from(object.capacity)).sum();
    let allowed = gpu.device.limits().max_storage_buffer_binding_size / RECORD_BYTES;
    if asked > allowed {
        return Err(Error::TooMany { asked, allowed });
    }
    let mut first = 0;
    let mut ranges = Vec::with_capacity(objects.len());
    for (index, (played, object)) in objects.iter_mut().zip(&scene.objects).enumerate() {
        played.placement.first = first;
        let range = first..first + played.capacity;
        first = range.end;
        ranges.push(PuffObject { range, wants_form: object.visible && wants_form(scene, index) });
    }
    Ok(PuffScene::new(gpu, atlas, ranges, size_of::<ObjectStyle>() as u64))
}

/// Normals of puffs and volumes bend toward the form, and relief is what stands out from it.
fn wants_form(scene: &Scene, index: usize) -> bool {
    let is_surface = scene.objects[index].shape.surface().is_some();
    scene.styles_of(index).any(|style| (style.form > 0.0 && !is_surface) || style.exaggerate.amount > 0.0)
}
