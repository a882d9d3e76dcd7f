//! Volumes, made of puffs that have their places.

use fumetto_scene::Scene;
use wgpu::util::DeviceExt as _;

use super::{PlayedMatter, PlayedObject};
use crate::{
    Error,
    gpu::Gpu,
    light::LightsUniform,
    shapes::volume::{Source, VolumeObject, VolumeScene},
};

/// All volumes, of puffs that have their places.
pub(super) fn volumes(gpu: &Gpu, scene: &Scene, objects: &[PlayedObject]) -> Result<VolumeScene, Error> {
    let mut volumes = Vec::new();
    for (index, (object, played)) in scene.objects.iter().zip(objects).enumerate() {
        let Some(volume) = object.shape.volume() else { continue };
        let (source, moves) = match &played.matter {
            PlayedMatter::Still(particles) => (Source::Puffs(volume.room(particles)), false),
            PlayedMatter::Sequence(..) | PlayedMatter::Morph(_) | PlayedMatter::Smoke(_) => {
                (Source::Puffs(volume.moving_room()), true)
            }
            PlayedMatter::Imported(volume) => (Source::File(Box::new(volume.field.clone())), false),
            PlayedMatter::Model(_) | PlayedMatter::Paint => continue,
        };
        let first = played.placement.first;
        let volume = VolumeObject {
            object: index,
            volume: volume.clone(),
            source,
            puffs: first..first + played.capacity,
            moves,
            shadows: object.style.shadow.on,
            casts: scene.casts(object),
        };
        volume.check().map_err(|source| Error::Volume { object: object.name.clone(), source })?;
        volumes.push(volume);
    }
    let lights = gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("player.lights"),
        contents: bytemuck::bytes_of(&LightsUniform::of(scene)),
        usage: wgpu::BufferUsages::UNIFORM,
    });
    Ok(VolumeScene::new(gpu, volumes, lights))
}
