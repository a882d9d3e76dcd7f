//! Bricks with matter, and the table that finds them.

use std::collections::BTreeMap;

use fumetto_formats::{BRICK_SIDE, BRICK_VOXELS, Brick, Tile};
use fumetto_scene::{Particle, limits::MAX_VOLUME_BYTES};
use glam::{DMat4, DVec3, Vec3};
use half::f16;

use super::{
    ImportError,
    cover::cover,
    lobes::Lobes,
    samples::{IN_BRICK, SIDE, Samples},
};

/// Bricks along a node's side. Also in `brick.wgsl`.
pub(super) const NODE: i32 = 16;

/// Voxels along a node's side.
const NODE_VOXELS: i32 = NODE * BRICK_SIDE;

/// Bricks of a node.
const IN_NODE: usize = (NODE * NODE * NODE) as usize;

/// Voxels that a ray may go along an axis: beyond, single floats neither place them well nor count its steps.
pub(super) const MAX_ACROSS: u64 = 1 << 20;

/// Bytes of the table of nodes.
pub(super) const MAX_TABLE_BYTES: u64 = MAX_VOLUME_BYTES / 4;

/// Bricks that are looked at, at most.
const MAX_LOOKED_AT: u64 = 1 << 23;

/// Bricks with matter, as the GPU takes them.
#[derive(Debug)]
pub(crate) struct BrickMap {
    /// Along the axes; none where there is no matter.
    pub(super) nodes: [u32; 3],
    /// For each node where its bricks begin here, or 0; then for each brick of those nodes its number + 1, or 0.
    pub(super) table: Vec<u32>,
    /// Half floats: a density, and where there is heat, density times heat; 9³ to a brick.
    pub(super) samples: Vec<u16>,
    /// The least and the most density of each brick.
    pub(super) extremes: Vec<[f32; 2]>,
    pub(super) has_heat: bool,
    /// What the samples are multiplied by.
    pub(crate) peak: f32,
    /// From voxels, counted from the first node's corner.
    pub(super) world_from_voxel: DMat4,
    /// The box around all matter, in these voxels.
    pub(super) ends: [Vec3; 2],
    /// For style: balls of the size of lobes.
    pub(crate) lobes: Vec<Particle>,
    /// For surfaces: balls that cover all bricks.
    pub(crate) cover: Vec<Particle>,
    /// Voxels with any matter.
    pub(crate) voxels: u64,
}

impl BrickMap {
    /// Keeps what is dense of `samples`; lobes have the radius `lobe_m`, if the scene says so.
    pub(crate) fn new(samples: &Samples<'_>, lobe_m: Option<f32>) -> Result<Self, ImportError> {
        let origins = origins(samples)?;
        let (mut map, corner) = Self::around(samples, &origins)?;
        if origins.is_empty() {
            return Ok(map);
        }
        let ends = [0, 1].map(|end| {
            let of =
                |origin: &[i32; 3]| DVec3::from(origin.map(|i| f64::from(i) + f64::from(end * BRICK_SIDE)));
            let all = origins.iter().map(of);
            if end == 0 { all.reduce(DVec3::min) } else { all.reduce(DVec3::max) }.unwrap_or(corner)
        });
        map.ends = ends.map(|end| (end - corner).as_vec3());
        let mut lobes = Lobes::new(samples.world_from_index, ends, lobe_m);
        let mut uniform = BTreeMap::new();
        let mut kept = Vec::new();
        for &origin in &origins {
            let (density, heat) = samples.brick(origin);
            if density.iter().any(|&density| density > 0.0) {
                kept.push(origin);
                map.voxels += own_voxels(&density);
                lobes.add(origin, &density);
                let voxel = [0, 1, 2].map(|axis| (f64::from(origin[axis]) - corner[axis]) as usize);
                let number = map.keep(&density, heat.as_ref(), &mut uniform)?;
                map.enter(voxel.map(|index| index / BRICK_SIDE as usize), number);
            }
        }
        map.lobes = lobes.balls();
        map.cover = cover(samples.world_from_index, &kept);
        Ok(map)
    }

    /// The table for bricks that begin at `origins`, without any of them yet, and the index at its corner.
    fn around(samples: &Samples<'_>, origins: &[[i32; 3]]) -> Result<(Self, DVec3), ImportError> {
        let node = |index: i32| i64::from(index.div_euclid(NODE_VOXELS));
        let low = [0, 1, 2].map(|axis| origins.iter().map(|origin| node(origin[axis])).min().unwrap_or(0));
        let high =
            [0, 1, 2].map(|axis| origins.iter().map(|origin| node(origin[axis]) + 1).max().unwrap_or(0));
        let nodes = [0, 1, 2].map(|axis| (high[axis] - low[axis]) as u64);
        let bytes = nodes.iter().fold(4, |bytes: u64, &side| bytes.saturating_mul(side));
        let sides = nodes.map(|side| side * NODE_VOXELS as u64);
        if bytes > MAX_TABLE_BYTES || sides.iter().any(|&side| side > MAX_ACROSS) {
            return Err(ImportError::TooWide { sides, bytes });
        }
        let corner = DVec3::from(low.map(|node| (node * i64::from(NODE_VOXELS)) as f64));
        let map = Self {
            nodes: nodes.map(|side| side as u32),
            table: vec![0; (bytes / 4) as usize],
            samples: Vec::new(),
            extremes: Vec::new(),
            has_heat: samples.has_heat(),
            peak: samples.peak().max(f32::MIN_POSITIVE),
            world_from_voxel: samples.world_from_index * DMat4::from_translation(corner),
            ends: [Vec3::ZERO; 2],
            lobes: Vec::new(),
            cover: Vec::new(),
            voxels: 0,
        };
        Ok((map, corner))
    }

    /// Bytes that it takes on the GPU.
    pub(crate) fn bytes(&self) -> u64 {
        (size_of_val(&*self.table) + size_of_val(&*self.samples) + size_of_val(&*self.extremes)) as u64
    }

    /// Bricks that are kept.
    pub(crate) fn bricks(&self) -> u32 {
        (self.samples.len() / (IN_BRICK * self.channels())) as u32
    }

    pub(super) fn channels(&self) -> usize {
        1 + usize::from(self.has_heat)
    }

    /// Keeps a brick, unless one that is the same all over is there already: its number.
    fn keep(
        &mut self,
        density: &[f32; IN_BRICK],
        heat: Option<&[f32; IN_BRICK]>,
        uniform: &mut BTreeMap<[u16; 2], u32>,
    ) -> Result<u32, ImportError> {
        let texel = |sample: usize| {
            let share = density[sample] / self.peak;
            let hot = heat.map_or(0.0, |heat| share * heat[sample]);
            [share, hot].map(|number| f16::from_f32(number).to_bits())
        };
        let texels: [[u16; 2]; IN_BRICK] = std::array::from_fn(texel);
        let is_uniform = texels.iter().all(|texel| *texel == texels[0]);
        if let Some(&number) = uniform.get(&texels[0]).filter(|_| is_uniform) {
            return Ok(number);
        }
        let number = self.bricks();
        let channels = self.channels();
        self.samples.extend(texels.iter().flat_map(|texel| &texel[..channels]));
        let stored = || texels.iter().map(|[density, _]| self.peak * f16::from_bits(*density).to_f32());
        self.extremes.push([stored().fold(f32::INFINITY, f32::min), stored().fold(0.0, f32::max)]);
        if is_uniform {
            uniform.insert(texels[0], number);
        }
        if self.bytes() > MAX_VOLUME_BYTES {
            return Err(ImportError::TooLarge { bricks: u64::from(number), bytes: self.bytes() });
        }
        Ok(number)
    }

    /// Notes the number of a brick.
    fn enter(&mut self, brick: [usize; 3], number: u32) {
        let nodes = self.nodes.map(|side| side as usize);
        let node = within(brick.map(|index| index / NODE as usize), nodes);
        if self.table[node] == 0 {
            self.table[node] = self.table.len() as u32;
            self.table.resize(self.table.len() + IN_NODE, 0);
        }
        if let Some(entry) = entry_of(&self.table, nodes, brick) {
            self.table[entry] = number + 1;
        }
    }
}

/// The index of a cell in a box.
fn within([x, y, z]: [usize; 3], [width, height, _]: [usize; 3]) -> usize {
    (z * height + y) * width + x
}

/// Where the table tells of a brick, if its node has any.
pub(super) fn entry_of(table: &[u32], nodes: [usize; 3], brick: [usize; 3]) -> Option<usize> {
    let side = NODE as usize;
    let first = table[within(brick.map(|index| index / side), nodes)] as usize;
    (first > 0).then(|| first + within(brick.map(|index| index % side), [side; 3]))
}

/// Where bricks begin that may hold matter, those included that only share a layer with one that does.
fn origins(samples: &Samples<'_>) -> Result<Vec<[i32; 3]>, ImportError> {
    let voxels = samples.voxels();
    let tiles = || voxels.tiles.iter().filter(|tile| samples.is_dense(tile.value[0]));
    let in_tile = |tile: &Tile| (u64::from(tile.side.unsigned_abs()) / 8 + 1).pow(3);
    let asked = tiles().map(in_tile).fold(voxels.bricks.len() as u64 * 8, u64::saturating_add);
    if asked > MAX_LOOKED_AT {
        let bytes = asked.saturating_mul(2 * IN_BRICK as u64);
        return Err(ImportError::TooLarge { bricks: asked, bytes });
    }
    let mut origins = Vec::new();
    for (brick, values) in voxels.bricks.iter().zip(voxels.values.chunks_exact(BRICK_VOXELS)) {
        push_brick(&mut origins, brick, values, |number| samples.is_dense(number));
    }
    for tile in tiles() {
        let steps = || (-1..tile.side / BRICK_SIDE).map(|step| step * BRICK_SIDE);
        for (x, y, z) in steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| (x, y, z)))) {
            push(&mut origins, tile.origin, [x, y, z]);
        }
    }
    origins.sort_unstable();
    origins.dedup();
    Ok(origins)
}

fn push(origins: &mut Vec<[i32; 3]>, origin: [i32; 3], step: [i32; 3]) {
    let [x, y, z] = [0, 1, 2].map(|axis| origin[axis].checked_add(step[axis]));
    if let (Some(x), Some(y), Some(z)) = (x, y, z) {
        origins.push([x, y, z]);
    }
}

/// Adds a brick that has any matter, and those below it that share a layer of it.
fn push_brick(origins: &mut Vec<[i32; 3]>, brick: &Brick, values: &[f32], is_dense: impl Fn(f32) -> bool) {
    // For each set of axes, whether matter lies in the first layer along just these.
    let mut found = [false; 8];
    for (voxel, _) in values.iter().enumerate().filter(|(_, number)| is_dense(**number)) {
        let at = [voxel & 7, voxel >> 3 & 7, voxel >> 6];
        found[(0..3).filter(|&axis| at[axis] == 0).map(|axis| 1 << axis).sum::<usize>()] = true;
    }
    for axes in 0..8_usize {
        if (0..8).any(|set| found[set] && set & axes == axes) {
            let step = [0, 1, 2].map(|axis| if axes >> axis & 1 == 1 { -BRICK_SIDE } else { 0 });
            push(origins, brick.origin, step);
        }
    }
}

/// Voxels with matter that are a brick's own.
fn own_voxels(density: &[f32; IN_BRICK]) -> u64 {
    let layers = density.chunks_exact(SIDE * SIDE).take(SIDE - 1);
    let rows = layers.flat_map(|layer| layer.chunks_exact(SIDE).take(SIDE - 1));
    rows.map(|row| row[..SIDE - 1].iter().filter(|&&density| density > 0.0).count() as u64).sum()
}
