//! What the numbers of a file mean: density and heat of its voxels.

use std::sync::Arc;

use fumetto_formats::{BRICK_SIDE, BRICK_VOXELS, Brick, Grid, GridClass, Tile, Volume, Voxels};
use fumetto_scene::Imported;
use glam::{DMat4, DVec3};

use super::ImportError;
use crate::shapes::mesh::world_from_file;

/// Voxels along a brick's side with the layer that it shares with the next one.
pub(super) const SIDE: usize = BRICK_SIDE as usize + 1;

/// Samples of a brick.
pub(super) const IN_BRICK: usize = SIDE * SIDE * SIDE;

/// The name of a density that is looked for if the scene names none.
const DENSITY: &str = "density";

/// No more heat than this: a half float holds it with room to spare.
const HOTTEST: f32 = 1e3;

/// The density of a file's voxels, and how hot they are.
pub(crate) struct Samples<'a> {
    density: &'a Voxels,
    to_density: Line,
    heat: Option<Heat<'a>>,
    /// Up and the object's place included.
    pub(super) world_from_index: DMat4,
}

struct Heat<'a> {
    voxels: &'a Voxels,
    to_heat: Line,
    /// From indices of the density, if these differ.
    index: Option<DMat4>,
}

/// A straight line through 0 and 1.
#[derive(Clone, Copy)]
struct Line {
    zero: f32,
    per_unit: f32,
}

impl Line {
    fn new([zero, one]: [f32; 2]) -> Self {
        Self { zero, per_unit: 1.0 / (one - zero) }
    }

    /// At least 0.
    fn at(self, number: f32) -> f32 {
        ((number - self.zero) * self.per_unit).max(0.0)
    }
}

impl<'a> Samples<'a> {
    /// Of what was read as `imported` says.
    pub(crate) fn new(volume: &'a Volume, imported: &Imported) -> Result<Self, ImportError> {
        let grid = chosen(volume, imported)?;
        let to_density = Line::new(imported.range.unwrap_or_else(|| usual_range(grid)));
        let background = grid.voxels.background[0];
        if to_density.at(background) > 0.0 {
            return Err(ImportError::DenseOutside { background });
        }
        let heat = match &imported.heat {
            Some(name) => Some(heat(named(volume, name)?, grid, imported)),
            None => None,
        };
        let world_from_file = world_from_file(&imported.place, imported.z_up).as_dmat4();
        let world_from_index = world_from_file * DMat4::from_cols_array_2d(&grid.world_from_index);
        Ok(Self { density: &grid.voxels, to_density, heat, world_from_index })
    }

    pub(super) fn has_heat(&self) -> bool {
        self.heat.is_some()
    }

    pub(super) fn voxels(&self) -> &'a Voxels {
        self.density
    }

    pub(super) fn is_dense(&self, number: f32) -> bool {
        self.to_density.at(number) > 0.0
    }

    /// The density, and the heat as "temperature", where the object stands: for other programs.
    pub(crate) fn grids(&self) -> Vec<Grid> {
        let grid = |name: &str, class, voxels: &Voxels, line: Line, world_from_index: DMat4| Grid {
            name: name.to_owned(),
            class,
            world_from_index: world_from_index.to_cols_array_2d(),
            voxels: Arc::new(mapped(voxels, line)),
        };
        let density =
            grid("density", GridClass::FogVolume, self.density, self.to_density, self.world_from_index);
        let heat = self.heat.as_ref().map(|heat| {
            let to_own = heat.index.map_or(DMat4::IDENTITY, |index| index.inverse());
            let world_from_index = self.world_from_index * to_own;
            grid("temperature", GridClass::Unknown, heat.voxels, heat.to_heat, world_from_index)
        });
        [density].into_iter().chain(heat).collect()
    }

    /// The largest density that is stored.
    pub(super) fn peak(&self) -> f32 {
        let tiles = self.density.tiles.iter().map(|tile| tile.value[0]);
        let stored = self.density.values.iter().copied().chain(tiles);
        stored.map(|number| self.to_density.at(number)).fold(0.0, f32::max)
    }

    /// The densities of the brick that begins at `origin`, and how hot it is there. Along x first, then y, then z.
    pub(super) fn brick(&self, origin: [i32; 3]) -> ([f32; IN_BRICK], Option<[f32; IN_BRICK]>) {
        let density = gathered(self.density, origin).map(|number| self.to_density.at(number));
        let heat = self.heat.as_ref().map(|heat| {
            let numbers = match &heat.index {
                None => gathered(heat.voxels, origin),
                Some(index) => resampled(heat.voxels, origin, index),
            };
            numbers.map(|number| heat.to_heat.at(number).min(HOTTEST))
        });
        (density, heat)
    }
}

/// Voxels whose numbers are what they mean; those that mean nothing are not active.
fn mapped(voxels: &Voxels, line: Line) -> Voxels {
    let value = |value: [f32; 3]| [line.at(value[0]), 0.0, 0.0];
    let values: Vec<f32> = voxels.values.iter().map(|&number| line.at(number)).collect();
    let brick = |(brick, values): (&Brick, &[f32])| {
        let layer = |values: &[f32]| {
            (0..).zip(values).map(|(bit, &value)| u64::from(value > 0.0) << bit).sum::<u64>()
        };
        let mut layers = values.chunks_exact(BRICK_VOXELS / 8).map(layer);
        Brick { origin: brick.origin, active: [(); 8].map(|()| layers.next().unwrap_or_default()) }
    };
    let tile = |tile: &Tile| Tile { value: value(tile.value), active: line.at(tile.value[0]) > 0.0, ..*tile };
    Voxels {
        channels: 1,
        background: value(voxels.background),
        bricks: voxels.bricks.iter().zip(values.chunks_exact(BRICK_VOXELS)).map(brick).collect(),
        tiles: voxels.tiles.iter().map(tile).collect(),
        values,
    }
}

/// The grid that is the density.
fn chosen<'a>(volume: &'a Volume, imported: &Imported) -> Result<&'a Grid, ImportError> {
    if let Some(name) = &imported.density {
        return named(volume, name);
    }
    let is_heat = |grid: &&Grid| imported.heat.as_deref() == Some(&*grid.name);
    let first = || volume.grids.iter().find(|grid| grid.voxels.channels == 1 && !is_heat(grid));
    named(volume, DENSITY).or_else(|error| first().ok_or(error))
}

fn named<'a>(volume: &'a Volume, name: &str) -> Result<&'a Grid, ImportError> {
    let found = volume.grids.iter().find(|grid| grid.name == name && grid.voxels.channels == 1);
    found.ok_or_else(|| {
        let names: Vec<String> = volume.grids.iter().map(|grid| format!("{:?}", grid.name)).collect();
        ImportError::NoGrid { wanted: format!("{name:?}"), found: names.join(", ") }
    })
}

/// Of a level set, whose numbers are distances, from a voxel outside to a voxel inside.
fn usual_range(grid: &Grid) -> [f32; 2] {
    if grid.class != GridClass::LevelSet {
        return [0.0, 1.0];
    }
    let voxel = DMat4::from_cols_array_2d(&grid.world_from_index).transform_vector3(DVec3::X).length() as f32;
    [voxel, -voxel]
}

fn heat<'a>(grid: &'a Grid, density: &Grid, imported: &Imported) -> Heat<'a> {
    let [own, other] = [grid, density].map(|grid| DMat4::from_cols_array_2d(&grid.world_from_index));
    let index = (own != other).then(|| own.inverse() * other);
    Heat { voxels: &grid.voxels, to_heat: Line::new(imported.heat_range), index }
}

/// The numbers of a brick and of the next layers of its neighbours.
fn gathered(voxels: &Voxels, origin: [i32; 3]) -> [f32; IN_BRICK] {
    let mut numbers = [0.0; IN_BRICK];
    for corner in 0..8_usize {
        let upper = [corner & 1, corner >> 1 & 1, corner >> 2];
        let place = [0, 1, 2].map(|axis| origin[axis].saturating_add(BRICK_SIDE * upper[axis] as i32));
        let own = voxels.bricks.binary_search_by_key(&place, |brick| brick.origin).ok();
        let values = own.map(|brick| &voxels.values[brick * BRICK_VOXELS..][..BRICK_VOXELS]);
        let same = if values.is_none() { voxels.at(place).0[0] } else { 0.0 };
        let range = |axis: usize| if upper[axis] == 1 { 8..9 } else { 0..8 };
        for z in range(2) {
            for y in range(1) {
                for x in range(0) {
                    let within = (x & 7) + 8 * ((y & 7) + 8 * (z & 7));
                    numbers[x + SIDE * (y + SIDE * z)] = values.map_or(same, |values| values[within]);
                }
            }
        }
    }
    numbers
}

/// The numbers nearest to where another grid has its voxels.
fn resampled(voxels: &Voxels, origin: [i32; 3], index: &DMat4) -> [f32; IN_BRICK] {
    std::array::from_fn(|sample| {
        let step = [sample % SIDE, sample / SIDE % SIDE, sample / (SIDE * SIDE)];
        let place = [0, 1, 2].map(|axis| f64::from(origin[axis]) + step[axis] as f64);
        let nearest = index.transform_point3(place.into()).round().to_array();
        voxels.at(nearest.map(|i| i as i32)).0[0]
    })
}
