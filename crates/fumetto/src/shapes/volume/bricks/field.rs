//! A volume out of a file, on the GPU.

use fumetto_scene::limits::MAX_VOLUME_BYTES;
use glam::{Mat4, Vec3};
use wgpu::util::DeviceExt as _;

use super::{BrickMap, ImportError, samples::SIDE, table::table};
use crate::gpu::Gpu;

/// `BrickGrid` of `bricks.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct BrickGrid {
    voxel_from_world: [[f32; 4]; 4],
    world_from_voxel: [[f32; 4]; 4],
    low: [f32; 3],
    peak: f32,
    high: [f32; 3],
    light_side: f32,
    nodes: [u32; 3],
    has_heat: u32,
    light_sides: [u32; 3],
    pad: u32,
    slots: [u32; 3],
    pad_end: u32,
}

/// Bricks, the table that finds them, and the light in them.
#[derive(Clone, Debug)]
pub(crate) struct BrickField {
    pub(crate) grid: wgpu::Buffer,
    pub(crate) table: wgpu::Buffer,
    pub(crate) atlas: wgpu::Texture,
    /// The least and the most density of each brick.
    pub(in crate::shapes) extremes: wgpu::Buffer,
    /// How much of each light that throws shadows comes through.
    pub(in crate::shapes::volume) transmitted: wgpu::Texture,
    pub(in crate::shapes::volume) light_sides: [u32; 3],
}

impl BrickField {
    /// With at most so many cells of light along the longest side.
    ///
    /// # Errors
    /// When the device has no room for it.
    pub(crate) fn new(gpu: &Gpu, map: &BrickMap, light_cells: u32) -> Result<Self, ImportError> {
        let slots = slots(gpu, map)?;
        let extent = (map.ends[1] - map.ends[0]).max(Vec3::ONE);
        let light_side = (extent.max_element() / light_cells as f32).max(1.0);
        let light_sides = (extent / light_side).ceil().max(Vec3::ONE).to_array().map(|side| side as u32);
        let grid = BrickGrid {
            voxel_from_world: map.world_from_voxel.inverse().as_mat4().to_cols_array_2d(),
            world_from_voxel: Mat4::to_cols_array_2d(&map.world_from_voxel.as_mat4()),
            low: map.ends[0].to_array(),
            peak: map.peak,
            high: map.ends[1].to_array(),
            light_side,
            nodes: map.nodes,
            has_heat: map.has_heat.into(),
            light_sides,
            pad: 0,
            slots,
            pad_end: 0,
        };
        let buffer = |label, contents| {
            gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some(label),
                contents,
                usage: wgpu::BufferUsages::STORAGE,
            })
        };
        let table = table(map, slots);
        let extremes: &[[f32; 2]] = if map.extremes.is_empty() { &[[0.0; 2]] } else { &map.extremes };
        let written = wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::TEXTURE_BINDING;
        let halves =
            if map.has_heat { wgpu::TextureFormat::Rg16Float } else { wgpu::TextureFormat::R16Float };
        let read = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
        let sides = slots.map(|side| side * SIDE as u32);
        let field = Self {
            grid: buffer("shapes.volume.bricks.grid", bytemuck::bytes_of(&grid)),
            table: buffer("shapes.volume.bricks.table", bytemuck::cast_slice(&table)),
            extremes: buffer("shapes.volume.bricks.extremes", bytemuck::cast_slice(extremes)),
            atlas: texture(gpu, "shapes.volume.bricks.atlas", sides, (halves, read)),
            transmitted: texture(
                gpu,
                "shapes.volume.bricks.transmitted",
                light_sides,
                (wgpu::TextureFormat::Rgba16Float, written),
            ),
            light_sides,
        };
        upload(gpu, map, &field.atlas, slots);
        Ok(field)
    }
}

/// Bricks along the sides of an atlas that has room for all of them, as cubic as may be.
fn slots(gpu: &Gpu, map: &BrickMap) -> Result<[u32; 3], ImportError> {
    let limits = gpu.device.limits();
    let bricks = map.bricks().max(1);
    let refused = ImportError::TooLarge { bricks: bricks.into(), bytes: map.bytes() };
    let table_bytes = (map.table.len() * size_of::<u32>()) as u64;
    if table_bytes > limits.max_storage_buffer_binding_size || map.bytes() > MAX_VOLUME_BYTES {
        return Err(refused);
    }
    let most = limits.max_texture_dimension_3d / SIDE as u32;
    let side = (1..most).find(|side| side.pow(3) >= bricks).unwrap_or(most);
    let layers = bricks.div_ceil(side * side);
    if layers > most { Err(refused) } else { Ok([side, side, layers]) }
}

fn texture(
    gpu: &Gpu,
    label: &str,
    [width, height, depth_or_array_layers]: [u32; 3],
    (format, usage): (wgpu::TextureFormat, wgpu::TextureUsages),
) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D3,
        format,
        usage,
        view_formats: &[],
    })
}

/// Writes bricks layer by layer: each is as many rows as a brick is high, of all bricks that lie side by side.
fn upload(gpu: &Gpu, map: &BrickMap, atlas: &wgpu::Texture, [across, down, _]: [u32; 3]) {
    let [width, height] = [across, down].map(|bricks| bricks as usize * SIDE);
    let row = SIDE * map.channels();
    let in_brick = row * SIDE * SIDE;
    let mut layer = vec![0_u16; width * map.channels() * height * SIDE];
    for (number, bricks) in map.samples.chunks(in_brick * (across * down) as usize).enumerate() {
        for (place, brick) in bricks.chunks_exact(in_brick).enumerate() {
            let [column, line] = [place % across as usize, place / across as usize];
            for (index, from) in brick.chunks_exact(row).enumerate() {
                let (y, z) = (line * SIDE + index % SIDE, index / SIDE);
                let start = ((z * height + y) * across as usize + column) * row;
                layer[start..start + row].copy_from_slice(from);
            }
        }
        let mut to = atlas.as_image_copy();
        to.origin.z = (number * SIDE) as u32;
        gpu.queue.write_texture(
            to,
            bytemuck::cast_slice(&layer),
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some((width * map.channels() * size_of::<u16>()) as u32),
                rows_per_image: Some(height as u32),
            },
            wgpu::Extent3d { width: width as u32, height: height as u32, depth_or_array_layers: SIDE as u32 },
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: BrickGrid, "BrickGrid" of "shapes/volume/bricks/march" { voxel_from_world, world_from_voxel, low, peak, high, light_side, nodes, has_heat, light_sides, slots });
}
