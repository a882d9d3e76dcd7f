use std::ops::Range;

use fumetto_scene::{SurfacePlan, SurfaceRoom};

use super::{Surface, SurfaceSize, SurfaceTooLarge, Workspace, recipe::Recipe, refusal::check};
use crate::{
    gpu::{Frame, Gpu, GpuError},
    shapes::mesh::MeshScene,
};

/// One object that is drawn as a surface.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceObject {
    pub(crate) surface: fumetto_scene::Surface,
    /// Of the puffs' radii and masses.
    pub(crate) scales: [f32; 2],
    pub(crate) plan: SurfacePlan,
    /// Its puffs in the list of all.
    pub(crate) puffs: Range<u32>,
    /// Whether it never moves, so that its surface is made but once.
    pub(crate) stands: bool,
}

/// All surfaces of a scene, in the order in which the scene's meshes have room for them.
#[derive(Debug)]
pub(crate) struct SurfaceScene {
    work: Option<Workspace>,
    surfaces: Vec<Made>,
}

#[derive(Debug)]
struct Made {
    recipe: Recipe,
    room: SurfaceRoom,
    stands: bool,
    /// Whether it has been made since the scene began.
    made: bool,
}

impl SurfaceObject {
    /// # Errors
    /// When the device has no room for it.
    pub(crate) fn check(&self, gpu: &Gpu) -> Result<(), SurfaceTooLarge> {
        check(gpu, self.plan.room)
    }
}

impl SurfaceScene {
    /// For objects whose room has been checked.
    pub(crate) fn new(gpu: &Gpu, objects: &[SurfaceObject]) -> Self {
        let room = objects.iter().map(|object| object.plan.room).reduce(SurfaceRoom::or);
        let surfaces = objects.iter().map(|object| Made {
            recipe: Recipe::new(&object.surface, object.scales, object.puffs.clone(), object.plan.spacing),
            room: object.plan.room,
            stands: object.stands,
            made: false,
        });
        Self { work: room.map(|room| Workspace::new(gpu, room)), surfaces: surfaces.collect() }
    }

    /// How large each surface is. Waits for the device.
    ///
    /// # Errors
    /// When the device is lost.
    pub(crate) fn sizes(&self, gpu: &Gpu, meshes: &MeshScene) -> Result<Vec<SurfaceSize>, GpuError> {
        let both = self.surfaces.iter().zip(&meshes.reserved);
        both.map(|(surface, mesh)| SurfaceSize::read(gpu, mesh, surface.room)).collect()
    }

    /// Makes the surfaces of what `puffs` are at the moment `secs`.
    pub(crate) fn record(
        &mut self,
        frame: &mut Frame<'_>,
        extraction: &Surface,
        puffs: &wgpu::Buffer,
        (secs, meshes): (f32, &MeshScene),
    ) {
        let Some(work) = &self.work else { return };
        for (surface, mesh) in self.surfaces.iter_mut().zip(&meshes.reserved) {
            if !(surface.stands && surface.made) {
                extraction.record(frame, puffs, &surface.recipe, (surface.room, work), (secs, mesh));
                surface.made = true;
            }
        }
    }
}
