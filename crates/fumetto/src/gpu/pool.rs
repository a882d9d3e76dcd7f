use std::{
    ops::Deref,
    sync::{Arc, Mutex, PoisonError},
};

/// Textures that passes borrow for part of a frame.
///
/// A [`Transient`] goes back when it is dropped, and a later pass of the same frame may take it: one
/// encoder runs in the order of recording, so nobody sees another's pixels.
#[derive(Clone, Debug, Default)]
pub(crate) struct TexturePool {
    shelf: Arc<Mutex<Vec<Shelved>>>,
}

#[derive(Debug)]
struct Shelved {
    texture: Arc<Texture>,
    /// Frames since somebody last took it.
    idle: u32,
}

#[derive(Debug)]
struct Texture {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
}

/// Frames after which an unused texture is freed: long enough to outlast a held drawing on threes.
const IDLE_FRAMES: u32 = 4;

impl TexturePool {
    /// A texture of just this size and format; what it holds is undefined.
    pub(crate) fn take(
        &self,
        device: &wgpu::Device,
        label: &'static str,
        size: [u32; 3],
        format: wgpu::TextureFormat,
    ) -> Transient {
        let mut shelf = self.shelf.lock().unwrap_or_else(PoisonError::into_inner);
        let extent = wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: size[2] };
        let found = shelf
            .iter()
            .position(|s| s.texture.texture.size() == extent && s.texture.texture.format() == format);
        let texture = found.map_or_else(
            || Arc::new(Texture::new(device, label, extent, format)),
            |i| shelf.swap_remove(i).texture,
        );
        Transient { texture, pool: self.clone() }
    }

    /// Frees all that nobody has at the moment: textures of this size are not wanted again soon.
    pub(crate) fn clear(&self) {
        self.shelf.lock().unwrap_or_else(PoisonError::into_inner).clear();
    }

    /// Ends a frame: textures that nobody has taken for a while are freed.
    pub(crate) fn end_frame(&self) {
        let mut shelf = self.shelf.lock().unwrap_or_else(PoisonError::into_inner);
        for shelved in shelf.iter_mut() {
            shelved.idle += 1;
        }
        shelf.retain(|shelved| shelved.idle < IDLE_FRAMES);
    }
}

impl Texture {
    fn new(device: &wgpu::Device, label: &str, size: wgpu::Extent3d, format: wgpu::TextureFormat) -> Self {
        // Kernels may read these with no sampler.
        let storage = match format {
            wgpu::TextureFormat::R32Float => wgpu::TextureUsages::STORAGE_BINDING,
            _ => wgpu::TextureUsages::empty(),
        };
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC
                | wgpu::TextureUsages::COPY_DST
                | storage,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Self { texture, view }
    }
}

/// A borrowed texture; stands for its view.
#[derive(Debug)]
pub(crate) struct Transient {
    texture: Arc<Texture>,
    pool: TexturePool,
}

impl Transient {
    /// The texture itself, to copy from.
    pub(crate) fn texture(&self) -> &wgpu::Texture {
        &self.texture.texture
    }
}

impl Deref for Transient {
    type Target = wgpu::TextureView;

    fn deref(&self) -> &wgpu::TextureView {
        &self.texture.view
    }
}

impl Drop for Transient {
    fn drop(&mut self) {
        let mut shelf = self.pool.shelf.lock().unwrap_or_else(PoisonError::into_inner);
        shelf.push(Shelved { texture: Arc::clone(&self.texture), idle: 0 });
    }
}
