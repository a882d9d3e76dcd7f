use std::ops::Range;

use super::{Gpu, GpuError};

/// Reads a whole texture of one mip level back, rows packed without padding, layer after layer.
///
/// For export only: it waits for the device.
///
/// # Errors
/// When the device is lost.
pub fn read_texture(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Vec<u8>, GpuError> {
    let size = texture.size();
    let texel = texture
        .format()
        .block_copy_size(Some(wgpu::TextureAspect::All))
        .ok_or_else(|| GpuError::Lost(format!("{:?} textures cannot be read back", texture.format())))?;
    let row = size.width * texel;
    let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let rows = u64::from(size.height) * u64::from(size.depth_or_array_layers);
    let staging = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("gpu.readback"),
        size: u64::from(padded) * rows,
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder =
        gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("gpu.readback") });
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &staging,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(padded),
                rows_per_image: Some(size.height),
            },
        },
        size,
    );
    gpu.queue.submit([encoder.finish()]);
    let bytes = read_mapped(gpu, &staging)?;
    let mut packed = Vec::with_capacity(row as usize * rows as usize);
    for line in bytes.chunks_exact(padded as usize) {
        packed.extend_from_slice(&line[..row as usize]);
    }
    Ok(packed)
}

/// Reads a whole buffer back; it must allow `COPY_SRC`.
///
/// For export and measurement only: it waits for the device.
pub(crate) fn read_buffer<T: bytemuck::Pod>(gpu: &Gpu, buffer: &wgpu::Buffer) -> Result<Vec<T>, GpuError> {
    read_items(gpu, buffer, 0..(buffer.size() / size_of::<T>() as u64) as u32)
}

/// Reads some of the items of a buffer back; it must allow `COPY_SRC`.
///
/// For export only: it waits for the device.
pub(crate) fn read_items<T: bytemuck::Pod>(
    gpu: &Gpu,
    buffer: &wgpu::Buffer,
    items: Range<u32>,
) -> Result<Vec<T>, GpuError> {
    if items.is_empty() {
        return Ok(Vec::new());
    }
    let item = size_of::<T>() as u64;
    let (offset, size) = (u64::from(items.start) * item, items.len() as u64 * item);
    let staging = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("gpu.readback"),
        size,
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder =
        gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("gpu.readback") });
    encoder.copy_buffer_to_buffer(buffer, offset, &staging, 0, size);
    gpu.queue.submit([encoder.finish()]);
    Ok(bytemuck::pod_collect_to_vec(&read_mapped(gpu, &staging)?))
}

fn read_mapped(gpu: &Gpu, staging: &wgpu::Buffer) -> Result<Vec<u8>, GpuError> {
    let (tell, told) = std::sync::mpsc::channel();
    staging.map_async(wgpu::MapMode::Read, .., move |result| {
        tell.send(result).ok();
    });
    gpu.wait()?;
    let mapped = told.recv().map_err(|error| GpuError::Lost(error.to_string()))?;
    mapped.map_err(|error| GpuError::Lost(error.to_string()))?;
    let view = staging.get_mapped_range(..).map_err(|error| GpuError::Lost(error.to_string()))?;
    Ok(view.to_vec())
}
