//! Volumes, made of puffs that have their places.

use fumetto_scene::Scene;
use wgpu::util::DeviceExt as _;

use super::{PlayedMatter, PlayedObject};
use crate::{
    Error,
    gpu::Gpu,
    light::LightsUniform,
    shapes::volume::{VolumeObject, VolumeScene},
};

/// All volumes, of puffs that have their places.
pub(super) fn volumes(gpu: &Gpu, scene: &Scene, objects: &[PlayedObject]) -> Result<VolumeScene, Error> {
    let mut volumes = Vec::new();
    for (index, (object, played)) in scene.objects.iter().zip(objects).enumerate() {
        let Some(volume) = object.shape.volume() else { continue };
        let room = match &played.matter {
            PlayedMatter::Still(particles) => volume.room(particles),
            PlayedMatter::Sequence(..) | PlayedMatter::Morph(_) | PlayedMatter::Smoke(_) => {
                volume.moving_room()
            }
            PlayedMatter::Model(_) | PlayedMatter::Paint => continue,
        };
        let first = played.placement.first;
        let volume = VolumeObject {
            object: index,
            volume: volume.clone(),
            room,
            puffs: first..first + played.capacity,
            moves: !matches!(played.matter, PlayedMatter::Still(_)),
            shadows: object.style.shadow.on,
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
