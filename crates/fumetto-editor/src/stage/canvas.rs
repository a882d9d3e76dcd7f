use eframe::egui_wgpu::RenderState;
use egui::TextureId;

/// A texture that the engine draws into and egui shows.
pub(crate) struct Canvas {
    render: RenderState,
    texture: Option<wgpu::Texture>,
    id: Option<TextureId>,
}

impl Canvas {
    pub(crate) fn new(render: RenderState) -> Self {
        Self { render, texture: None, id: None }
    }

    /// The texture, made anew where it has another size.
    pub(crate) fn texture(&mut self, [width, height]: [u32; 2]) -> &wgpu::Texture {
        let fits = |texture: &wgpu::Texture| [texture.width(), texture.height()] == [width, height];
        if !self.texture.as_ref().is_some_and(fits) {
            self.texture = None;
        }
        let device = &self.render.device;
        self.texture.get_or_insert_with(|| {
            device.create_texture(&wgpu::TextureDescriptor {
                label: Some("editor.canvas"),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: fumetto::PICTURE_FORMAT,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                    | wgpu::TextureUsages::TEXTURE_BINDING
                    | wgpu::TextureUsages::COPY_SRC,
                view_formats: &[],
            })
        })
    }

    /// What egui calls the texture that was drawn last.
    pub(crate) fn show(&mut self) -> Option<TextureId> {
        let view = self.texture.as_ref()?.create_view(&wgpu::TextureViewDescriptor::default());
        let (device, filter) = (&self.render.device, wgpu::FilterMode::Nearest);
        let mut renderer = self.render.renderer.write();
        match self.id {
            Some(id) => renderer.update_egui_texture_from_wgpu_texture(device, &view, filter, id),
            None => self.id = Some(renderer.register_native_texture(device, &view, filter)),
        }
        self.id
    }
}

impl Drop for Canvas {
    fn drop(&mut self) {
        if let Some(id) = self.id {
            self.render.renderer.write().free_texture(&id);
        }
    }
}
