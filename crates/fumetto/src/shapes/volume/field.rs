use fumetto_scene::VolumeRoom;

use crate::gpu::Gpu;

/// Cells along a block's side. Also in `grid.wgsl`.
pub(super) const BLOCK: u32 = 8;

/// Bytes of a `VolumeGrid` of `grid.wgsl`.
const GRID_BYTES: u64 = 48;

/// A density field, and the light in it: what rays are marched through.
#[derive(Debug)]
pub(crate) struct Field {
    pub(super) room: VolumeRoom,
    /// `VolumeGrid` of `grid.wgsl`: where the cells lie.
    pub(super) grid: wgpu::Buffer,
    /// Colour times density, and density.
    pub(super) density: wgpu::Texture,
    /// Number of the puff that is the densest there + 1; 0 where there is none.
    pub(super) owners: wgpu::Texture,
    /// 1 for each block in which there is any matter.
    pub(super) occupied: wgpu::Buffer,
    /// How much of each light that throws shadows comes through.
    pub(super) transmitted: wgpu::Texture,
}

impl Field {
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
            grid: buffer("shapes.volume.grid", GRID_BYTES),
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

    /// Workgroups of 4³ that cover the blocks.
    pub(super) fn block_groups(&self) -> [u32; 3] {
        self.room.cells.map(|side| side.div_ceil(BLOCK).div_ceil(4))
    }
}

pub(super) fn view(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
