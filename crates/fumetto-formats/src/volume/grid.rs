//! Numbers on a grid that is almost empty, whatever file they come from.

use std::sync::Arc;

use glam::DMat4;

/// Voxels along a side of a [`Brick`].
pub const BRICK_SIDE: i32 = 8;

/// Voxels of a [`Brick`].
pub const BRICK_VOXELS: usize = 512;

/// What a volume file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    /// The grids in the file's order; at least one. Several may have the same name.
    pub grids: Vec<Grid>,
    /// What the user should know about how the file was understood: sentences that name the file.
    pub notes: Vec<String>,
}

/// Voxels with a name and a place in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// What the numbers are, such as `density`; may be empty.
    pub name: String,
    /// How the numbers are meant.
    pub class: GridClass,
    /// From voxels' indices to world coordinates, in columns; affine, finite, and with an inverse.
    ///
    /// A voxel's value is that of the point which its index is mapped to, not of a cell's corner. Files
    /// do not say which way is up: Houdini writes +Y, Blender +Z.
    pub world_from_index: [[f64; 4]; 4],
    /// The numbers; grids that are instances of one another share them.
    pub voxels: Arc<Voxels>,
}

/// How the numbers of a grid are meant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GridClass {
    /// Nothing is said.
    #[default]
    Unknown,
    /// A density that is zero outside.
    FogVolume,
    /// Distances to a surface, negative inside, known in a narrow band round it.
    LevelSet,
    /// Velocities whose components stand at the centres of the voxels' lower faces.
    Staggered,
}

/// Numbers on a grid of voxels, stored where they are not all the same.
///
/// Everything that neither a brick nor a tile covers is inactive and has the background's value; bricks
/// and tiles do not overlap.
#[derive(Clone, Debug, PartialEq)]
pub struct Voxels {
    /// Numbers of a voxel: 1, or 3 of a vector.
    pub channels: usize,
    /// The value where nothing is stored; the first `channels` numbers count, the rest are 0.
    pub background: [f32; 3],
    /// Small cubes of voxels, ordered by origin.
    pub bricks: Vec<Brick>,
    /// The numbers of all bricks, [`BRICK_VOXELS`] times `channels` of them each, in the order of bricks.
    /// Within a brick, voxels follow each other along x, then y, then z, each with all its channels.
    pub values: Vec<f32>,
    /// Large cubes that have one value all over, ordered by origin.
    pub tiles: Vec<Tile>,
}

/// Eight by eight by eight voxels; their numbers are in [`Voxels::values`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Brick {
    /// The index of its first voxel; multiples of [`BRICK_SIDE`].
    pub origin: [i32; 3],
    /// Which voxels are active: a word for each layer in z, in it bit `x + 8 * y`.
    pub active: [u64; 8],
}

/// A cube with one value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tile {
    /// The index of its first voxel; multiples of `side`.
    pub origin: [i32; 3],
    /// Voxels along a side: 8, 128 or 4096.
    pub side: i32,
    /// The value; the first [`Voxels::channels`] numbers count, the rest are 0.
    pub value: [f32; 3],
    /// Whether its voxels are active.
    pub active: bool,
}

/// Whether voxels that are placed by this have a place and a size.
pub(super) fn has_inverse(world_from_index: &DMat4) -> bool {
    let affine = world_from_index.row(3).to_array() == [0.0, 0.0, 0.0, 1.0];
    affine && world_from_index.is_finite() && world_from_index.inverse().is_finite()
}

impl Voxels {
    /// The numbers of a brick.
    ///
    /// # Panics
    /// If there is no such brick.
    #[must_use]
    pub fn brick_values(&self, brick: usize) -> &[f32] {
        let length = BRICK_VOXELS * self.channels;
        &self.values[brick * length..][..length]
    }

    /// How many voxels are active, those within tiles included.
    #[must_use]
    pub fn active_count(&self) -> u64 {
        let in_bricks =
            self.bricks.iter().flat_map(|brick| brick.active).map(|layer| layer.count_ones().into());
        let tiles = self.tiles.iter().filter(|tile| tile.active);
        in_bricks.chain(tiles.map(|tile| u64::from(tile.side.unsigned_abs()).saturating_pow(3))).sum()
    }

    /// The least and the greatest index of active voxels along each axis; `None` if none is active.
    #[must_use]
    pub fn active_bounds(&self) -> Option<[[i32; 3]; 2]> {
        let tiles = self.tiles.iter().filter(|tile| tile.active);
        let cubes = tiles.map(|tile| [tile.origin, tile.origin.map(|least| least + (tile.side - 1))]);
        self.bricks.iter().filter_map(Brick::active_bounds).chain(cubes).reduce(|[low, high], [min, max]| {
            [0, 1]
                .map(|end| [0, 1, 2].map(|i| if end == 0 { low[i].min(min[i]) } else { high[i].max(max[i]) }))
        })
    }

    /// The value at `index`, and whether it is active.
    #[must_use]
    pub fn at(&self, index: [i32; 3]) -> ([f32; 3], bool) {
        let corner = |side: i32| index.map(|i| i & !(side - 1));
        let origin = corner(BRICK_SIDE);
        if let Ok(brick) = self.bricks.binary_search_by_key(&origin, |brick| brick.origin) {
            let [x, y, z] = [0, 1, 2].map(|axis| (index[axis] - origin[axis]) as usize);
            let mut value = [0.0; 3];
            let first = self.channels * (x + 8 * (y + 8 * z));
            value[..self.channels].copy_from_slice(&self.brick_values(brick)[first..][..self.channels]);
            return (value, self.bricks[brick].active[z] >> (x + 8 * y) & 1 == 1);
        }
        for side in [8, 128, 4096] {
            if let Ok(tile) = self.tiles.binary_search_by_key(&corner(side), |tile| tile.origin) {
                let tile = &self.tiles[tile];
                if tile.side >= side {
                    return (tile.value, tile.active);
                }
            }
        }
        (self.background, false)
    }
}

impl Brick {
    /// The least and the greatest index of its active voxels along each axis; `None` if none is active.
    fn active_bounds(&self) -> Option<[[i32; 3]; 2]> {
        let flat = self.active.iter().fold(0, |flat, layer| flat | layer);
        let row = flat.to_le_bytes().iter().fold(0, |row, bits| row | bits);
        let columns = flat.to_le_bytes().map(|bits| bits != 0);
        let layers = self.active.map(|layer| layer != 0);
        let range =
            |used: &dyn Fn(usize) -> bool| Some([(0..8).find(|&i| used(i))?, (0..8).rfind(|&i| used(i))?]);
        let [x, y, z] = [range(&|i| row >> i & 1 == 1)?, range(&|i| columns[i])?, range(&|i| layers[i])?];
        Some([0, 1].map(|end| {
            let [i, j, k] = [x[end], y[end], z[end]].map(|offset| offset as i32);
            [self.origin[0] + i, self.origin[1] + j, self.origin[2] + k]
        }))
    }
}
