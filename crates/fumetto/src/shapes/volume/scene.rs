use std::ops::Range;

use fumetto_scene::{VolumeRoom, limits::MAX_VOLUME_BYTES};
use thiserror::Error;

use super::{
    BrickField, Volume,
    field::{CellField, Field},
    recipe::{Recipe, RecipeUniform},
};
use crate::gpu::{Frame, Gpu};

/// A volume whose grids are larger than is allowed.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "a volume of {} x {} x {} cells needs {} bytes for its grids, and {MAX_VOLUME_BYTES} are allowed: choose \
     fewer `cells` or `light_cells`",
    .0.cells[0], .0.cells[1], .0.cells[2], .0.bytes()
)]
pub struct VolumeTooLarge(VolumeRoom);

/// One object that is drawn as a volume.
#[derive(Clone, Debug)]
pub(crate) struct VolumeObject {
    /// Its number in the scene.
    pub(crate) object: usize,
    pub(crate) volume: fumetto_scene::Volume,
    pub(crate) source: Source,
    /// Its puffs in the list of all; the lobes of what comes out of a file.
    pub(crate) puffs: Range<u32>,
    /// Whether its particles move.
    pub(crate) moves: bool,
    /// Whether it keeps light from itself.
    pub(crate) shadows: bool,
    /// Whether it may keep light from other things.
    pub(crate) casts: bool,
}

/// Where a volume's matter comes from.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    /// Puffs, with so much room.
    Puffs(VolumeRoom),
    /// A file.
    File(Box<BrickField>),
}

/// All volumes of a scene.
#[derive(Debug)]
pub(crate) struct VolumeScene {
    lights: wgpu::Buffer,
    pub(super) volumes: Vec<Made>,
}

/// One of them.
#[derive(Debug)]
pub(super) struct Made {
    pub(super) object: usize,
    pub(super) recipe: Recipe,
    pub(super) field: Field,
    /// Whether it has been made since the scene began.
    made: bool,
}

impl VolumeObject {
    /// # Errors
    /// When its grids would be larger than is allowed.
    pub(crate) fn check(&self) -> Result<(), VolumeTooLarge> {
        match self.source {
            Source::Puffs(room) if !room.fits() => Err(VolumeTooLarge(room)),
            Source::Puffs(_) | Source::File(_) => Ok(()),
        }
    }
}

impl VolumeScene {
    /// For objects whose room has been checked, in the light of `Lights` of `lights.wgsl`.
    pub(crate) fn new(gpu: &Gpu, objects: Vec<VolumeObject>, lights: wgpu::Buffer) -> Self {
        let made = |object: VolumeObject| Made {
            object: object.object,
            field: match object.source {
                Source::Puffs(room) => Field::Cells(CellField::new(gpu, room)),
                Source::File(field) => Field::Bricks(*field),
            },
            recipe: Recipe {
                volume: object.volume,
                puffs: object.puffs,
                moves: object.moves,
                shadows: object.shadows,
                casts: object.casts,
            },
            made: false,
        };
        Self { lights, volumes: objects.into_iter().map(made).collect() }
    }

    /// Makes the fields of what `puffs` now are, `secs` after the beginning, and of the light in them.
    pub(crate) fn record(&mut self, frame: &mut Frame<'_>, volume: &Volume, puffs: &wgpu::Buffer, secs: f32) {
        for made in &mut self.volumes {
            let changes = made.recipe.moves || made.recipe.volume.drifts();
            if changes || !made.made {
                let recipe = made.recipe.uniform(secs);
                volume.record(frame, puffs, &self.lights, &recipe, &made.field);
                made.made = true;
            }
        }
    }

    /// The field of an object's puffs, if it is a volume of them.
    pub(crate) fn cells(&self, object: usize) -> Option<&CellField> {
        let volume = self.volumes.iter().find(|volume| volume.object == object)?;
        match &volume.field {
            Field::Cells(field) => Some(field),
            Field::Bricks(_) => None,
        }
    }

    /// Puts what another file holds in the place of an object's field.
    pub(crate) fn renew(&mut self, object: usize, field: BrickField) {
        if let Some(volume) = self.volumes.iter_mut().find(|volume| volume.object == object) {
            volume.field = Field::Bricks(field);
            volume.made = false;
        }
    }

    /// Those that throw shadows on other things.
    pub(crate) fn casting(&self) -> impl Iterator<Item = (RecipeUniform, &Field)> {
        let recipe = |made: &Made| made.recipe.uniform(0.0);
        self.volumes
            .iter()
            .filter(|made| made.recipe.casts && made.recipe.volume.shadow > 0.0)
            .map(move |made| (recipe(made), &made.field))
    }

    /// Those of the objects that `members` numbers.
    pub(super) fn of<'a>(&'a self, members: &'a [usize]) -> impl Iterator<Item = &'a Made> {
        self.volumes.iter().filter(|made| members.contains(&made.object))
    }
}
