//! What the device made, back on the processor: for export and measurement only.
//!
//! The copy is asked for at once, so that what is drawn later does not change it. A future then hands it over: in a
//! browser it waits without blocking, and elsewhere it waits for the device. The functions that are not `async`
//! block, which a browser does not allow.

use std::ops::Range;

use futures_channel::oneshot::{self, Receiver};

use super::{Gpu, GpuError};

/// Reads a whole texture of one mip level back, rows packed without padding, layer after layer.
///
/// Blocks until the device is done.
///
/// # Errors
/// When the device is lost.
#[cfg(not(target_arch = "wasm32"))]
pub fn read_texture(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Vec<u8>, GpuError> {
    pollster::block_on(read_texture_async(gpu, texture))
}

/// Reads a whole texture of one mip level back, rows packed without padding, layer after layer.
///
/// # Errors
/// When the device is lost.
pub fn read_texture_async(
    gpu: &Gpu,
    texture: &wgpu::Texture,
) -> impl Future<Output = Result<Vec<u8>, GpuError>> + use<> {
    let (size, format) = (texture.size(), texture.format());
    let copied = format.block_copy_size(Some(wgpu::TextureAspect::All)).map(|texel| {
        let row = size.width * texel;
        let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let rows = u64::from(size.height) * u64::from(size.depth_or_array_layers);
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(padded),
            rows_per_image: Some(size.height),
        };
        let copied = Copied::new(gpu, u64::from(padded) * rows, |encoder, buffer| {
            let copy = wgpu::TexelCopyBufferInfo { buffer, layout };
            encoder.copy_texture_to_buffer(texture.as_image_copy(), copy, size);
        });
        (copied, row as usize, padded as usize)
    });
    async move {
        let (copied, row, padded) =
            copied.ok_or_else(|| GpuError::Lost(format!("{format:?} textures cannot be read back")))?;
        let bytes = copied.bytes().await?;
        let mut packed = Vec::with_capacity(bytes.len() / padded * row);
        for line in bytes.chunks_exact(padded) {
            packed.extend_from_slice(&line[..row]);
        }
        Ok(packed)
    }
}

/// Reads a whole buffer back; it must allow `COPY_SRC`. Blocks until the device is done.
#[cfg(test)]
pub(crate) fn read_buffer<T: bytemuck::Pod>(gpu: &Gpu, buffer: &wgpu::Buffer) -> Result<Vec<T>, GpuError> {
    let items = (buffer.size() / size_of::<T>() as u64) as u32;
    pollster::block_on(read_items(gpu, buffer, 0..items))
}

/// Reads some of the items of a buffer back; it must allow `COPY_SRC`.
pub(crate) fn read_items<T: bytemuck::Pod>(
    gpu: &Gpu,
    buffer: &wgpu::Buffer,
    items: Range<u32>,
) -> impl Future<Output = Result<Vec<T>, GpuError>> + use<T> {
    let item = size_of::<T>() as u64;
    let (offset, size) = (u64::from(items.start) * item, items.len() as u64 * item);
    let copied = (size > 0).then(|| {
        Copied::new(gpu, size, |encoder, staging| {
            encoder.copy_buffer_to_buffer(buffer, offset, staging, 0, size);
        })
    });
    async move {
        match copied {
            Some(copied) => Ok(bytemuck::pod_collect_to_vec(&copied.bytes().await?)),
            None => Ok(Vec::new()),
        }
    }
}

/// Bytes on their way to the processor.
struct Copied {
    gpu: Gpu,
    staging: wgpu::Buffer,
    mapped: Receiver<Result<(), wgpu::BufferAsyncError>>,
}

impl Copied {
    /// Asks for `size` bytes, which `copy` brings into the buffer that it gets.
    fn new(gpu: &Gpu, size: u64, copy: impl FnOnce(&mut wgpu::CommandEncoder, &wgpu::Buffer)) -> Self {
        let staging = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("gpu.readback"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("gpu.readback") });
        copy(&mut encoder, &staging);
        gpu.queue.submit([encoder.finish()]);
        let (tell, mapped) = oneshot::channel();
        staging.map_async(wgpu::MapMode::Read, .., move |result| {
            // Nobody listens any more where the future was dropped.
            tell.send(result).ok();
        });
        Self { gpu: gpu.clone(), staging, mapped }
    }

    async fn bytes(self) -> Result<Vec<u8>, GpuError> {
        let lost = |error: &dyn std::error::Error| GpuError::Lost(error.to_string());
        // In a browser this does nothing: there, the device goes on while others have the thread.
        self.gpu.wait()?;
        self.mapped.await.map_err(|error| lost(&error))?.map_err(|error| lost(&error))?;
        let view = self.staging.get_mapped_range(..).map_err(|error| lost(&error))?;
        Ok(view.to_vec())
    }
}
