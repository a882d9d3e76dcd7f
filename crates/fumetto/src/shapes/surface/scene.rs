use std::{cell::Cell, ops::Range};

use fumetto_scene::{Particle, Spacing, SurfacePlan, SurfaceRoom};

use super::{
    Sight, Surface, SurfaceSize, SurfaceTooLarge, Workspace, recipe::Recipe, refusal::check, sight::Balls,
};
use crate::{
    gpu::{Frame, Gpu, GpuError},
    shapes::{mesh::MeshScene, volume::BrickField},
};

/// One object that is drawn as a surface.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceObject<'a> {
    /// Its number in the scene.
    pub(crate) object: usize,
    pub(crate) surface: fumetto_scene::Surface,
    /// Of the puffs' radii and masses.
    pub(crate) scales: [f32; 2],
    pub(crate) plan: SurfacePlan,
    /// Its puffs in the list of all.
    pub(crate) puffs: Range<u32>,
    /// Its particles, if it never moves: its surface is made but once for the same cells.
    pub(crate) still: Option<&'a [Particle]>,
    /// Where a file tells the density: the puffs only cover it.
    pub(crate) bricks: Option<&'a BrickField>,
}

/// All surfaces of a scene, in the order in which the scene's meshes have room for them.
#[derive(Debug)]
pub(crate) struct SurfaceScene {
    work: Option<Workspace>,
    surfaces: Vec<Made>,
}

#[derive(Debug)]
struct Made {
    object: usize,
    recipe: Recipe,
    room: SurfaceRoom,
    /// Of what never moves.
    balls: Option<Balls>,
    /// What it was made with; none where it has yet to be made of the moment.
    made: Cell<Option<Cells>>,
}

/// What says how large cells are.
type Cells = (Spacing, Option<Sight>);

impl Made {
    /// For a picture from there; none where there is no picture yet, and it matters.
    fn cells(&self, sight: Option<Sight>) -> Option<Cells> {
        match (self.recipe.spacing, &self.balls) {
            (Spacing::Picture { share, most }, Some(balls)) => {
                Some((balls.spacing(sight?, share, most), None))
            }
            (spacing @ Spacing::Picture { .. }, None) => Some((spacing, Some(sight?))),
            (fixed, _) => Some((fixed, None)),
        }
    }
}

impl SurfaceObject<'_> {
    /// # Errors
    /// When the device has no room for it.
    pub(crate) fn check(&self, gpu: &Gpu) -> Result<(), SurfaceTooLarge> {
        check(gpu, self.plan.room)
    }
}

impl SurfaceScene {
    /// For objects whose room has been checked.
    pub(crate) fn new(gpu: &Gpu, objects: &[SurfaceObject<'_>]) -> Self {
        let room = objects.iter().map(|object| object.plan.room).reduce(SurfaceRoom::or);
        let surfaces = objects.iter().map(|object| Made {
            object: object.object,
            recipe: Recipe {
                bricks: object.bricks.cloned(),
                ..Recipe::new(&object.surface, object.scales, object.puffs.clone(), object.plan.spacing)
            },
            room: object.plan.room,
            balls: object.still.map(|still| Balls::new(&object.surface, object.scales[1], still)),
            made: Cell::new(None),
        });
        Self { work: room.map(|room| Workspace::new(gpu, room)), surfaces: surfaces.collect() }
    }

    /// How large each surface is.
    ///
    /// # Errors
    /// When the device is lost.
    pub(crate) async fn sizes(&self, gpu: &Gpu, meshes: &MeshScene) -> Result<Vec<SurfaceSize>, GpuError> {
        let mut sizes = Vec::with_capacity(self.surfaces.len());
        for (surface, mesh) in self.surfaces.iter().zip(&meshes.reserved) {
            sizes.push(SurfaceSize::read(gpu, mesh, surface.room).await?);
        }
        Ok(sizes)
    }

    /// Puts what another file holds in the place of an object's density.
    pub(crate) fn renew(&mut self, object: usize, field: &BrickField) {
        for surface in self.surfaces.iter_mut().filter(|surface| surface.object == object) {
            surface.recipe.bricks = Some(field.clone());
            surface.made.set(None);
        }
    }

    /// Whatever moves is no more what it was.
    pub(crate) fn move_on(&self) {
        for surface in self.surfaces.iter().filter(|surface| surface.balls.is_none()) {
            surface.made.set(None);
        }
    }

    /// Makes the surfaces of what `puffs` are at the moment `secs`, seen from `sight`, unless they are as they
    /// would become. Before anything is drawn, those have to wait whose cells are lengths on the picture.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        extraction: &Surface,
        puffs: &wgpu::Buffer,
        sight: Option<Sight>,
        (secs, meshes): (f32, &MeshScene),
    ) {
        let Some(work) = &self.work else { return };
        for (surface, mesh) in self.surfaces.iter().zip(&meshes.reserved) {
            let cells = surface.cells(sight);
            if let Some((spacing, sight)) = cells.filter(|_| cells != surface.made.get()) {
                let recipe = Recipe { spacing, sight, ..surface.recipe.clone() };
                extraction.record(frame, puffs, &recipe, (surface.room, work), (secs, mesh));
                surface.made.set(cells);
            }
        }
    }

    /// Whether a picture from `sight` has to wait for one of them.
    pub(crate) fn waits(&self, sight: Sight) -> bool {
        self.surfaces.iter().any(|surface| surface.cells(Some(sight)) != surface.made.get())
    }
}
