use fumetto_scene::VolumeRoom;

use super::bricks::BrickField;
use crate::gpu::Gpu;

/// Cells along a block's side. Also in `grid.wgsl`.
pub(super) const BLOCK: u32 = 8;

/// `VolumeGrid` of `grid.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct CellGrid {
    pub(crate) origin: [f32; 3],
    pub(crate) cell_m: f32,
    pub(crate) cells: [u32; 3],
    light_cell_m: f32,
    light_cells: [u32; 3],
    pad: f32,
}

/// A density field, and the light in it: what rays are marched through.
#[derive(Debug)]
pub(crate) enum Field {
    /// Of puffs.
    Cells(CellField),
    /// Out of a file.
    Bricks(BrickField),
}

/// A density field in the cells of a grid.
#[derive(Debug)]
pub(crate) struct CellField {
    pub(super) room: VolumeRoom,
    /// `VolumeGrid` of `grid.wgsl`: where the cells lie.
    pub(crate) grid: wgpu::Buffer,
    /// Colour times density, and density.
    pub(crate) density: wgpu::Texture,
    /// Number of the puff that is the densest there + 1; 0 where there is none.
    pub(super) owners: wgpu::Texture,
    /// 1 for each block in which there is any matter.
    pub(crate) occupied: wgpu::Buffer,
    /// How much of each light that throws shadows comes through.
    pub(super) transmitted: wgpu::Texture,
}

impl Field {
    /// Who owns which cell, where there are several who may.
    pub(super) fn owners(&self) -> Option<&wgpu::Texture> {
        match self {
            Self::Cells(field) => Some(&field.owners),
            Self::Bricks(_) => None,
        }
    }
}

impl CellField {
    /// Empty; its `room` has been checked.
    pub(crate) fn new(gpu: &Gpu, room: VolumeRoom) -> Self {
        let texture = |label, [width, height, depth_or_array_layers]: [u32; 3], format| {
            gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width, height, depth_or_array_layers },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D3,
                format,
                usage: wgpu::TextureUsages::STORAGE_BINDING
                    | wgpu::TextureUsages::TEXTURE_BINDING
                    | wgpu::TextureUsages::COPY_SRC,
                view_formats: &[],
            })
        };
        let buffer = |label, size| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            })
        };
        let blocks: u64 = room.cells.iter().map(|side| u64::from(side.div_ceil(BLOCK))).product();
        Self {
            room,
            grid: buffer("shapes.volume.grid", size_of::<CellGrid>() as u64),
            density: texture("shapes.volume.density", room.cells, wgpu::TextureFormat::Rgba16Float),
            owners: texture("shapes.volume.owners", room.cells, wgpu::TextureFormat::R32Uint),
            occupied: buffer("shapes.volume.occupied", 4 * blocks),
            transmitted: texture(
                "shapes.volume.transmitted",
                room.light_cells,
                wgpu::TextureFormat::Rgba16Float,
            ),
        }
    }

    /// Its [`CellGrid`].
    pub(crate) fn grid(&self) -> &wgpu::Buffer {
        &self.grid
    }

    /// Four halves to a cell, of which the last is the density.
    pub(crate) fn density(&self) -> &wgpu::Texture {
        &self.density
    }

    /// Workgroups of 4³ that cover the blocks.
    pub(super) fn block_groups(&self) -> [u32; 3] {
        self.room.cells.map(|side| side.div_ceil(BLOCK).div_ceil(4))
    }
}

pub(super) fn view(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: CellGrid, "VolumeGrid" of "shapes/volume/march" { origin, cell_m, cells, light_cell_m, light_cells });
}
