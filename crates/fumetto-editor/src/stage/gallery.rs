use std::collections::HashMap;

use eframe::egui_wgpu::RenderState;
use egui::TextureId;
use fumetto::Shot;
use fumetto_scene::presets;

use super::canvas::Canvas;
use super::{Stage, before_grey, with_causes};
use crate::project::Project;

/// How wide a picture of the gallery is, in pixels.
const WIDTH: u32 = 176;

/// Small pictures of the moment that is shown, in other styles.
pub(super) struct Gallery {
    render: RenderState,
    canvases: HashMap<&'static str, Canvas>,
    /// Which of the presets is drawn next.
    next: usize,
    /// The revision of the document and the frame that the pictures show.
    of: Option<(u64, u32)>,
}

impl Gallery {
    pub(super) fn new(render: RenderState) -> Self {
        Self { render, canvases: HashMap::new(), next: 0, of: None }
    }
}

impl Stage {
    /// Draws one more picture of the gallery, where the device has nothing else to do.
    pub(crate) fn draw_style(&mut self, project: &Project) -> Option<(&'static str, TextureId)> {
        let frame = self.frame()?;
        let of = (project.document().revision(), frame);
        if self.pace.is_busy() || !self.is_at_rest() {
            return None;
        }
        if self.gallery.of != Some(of) {
            (self.gallery.of, self.gallery.next) = (Some(of), 0);
        }
        let preset = presets::names().get(self.gallery.next).copied()?;
        self.gallery.next += 1;
        match self.style_picture(project, preset) {
            Ok(picture) => picture.map(|picture| (preset, picture)),
            Err(error) => {
                self.error = Some(with_causes(&error));
                None
            }
        }
    }

    fn style_picture(
        &mut self,
        project: &Project,
        preset: &'static str,
    ) -> Result<Option<TextureId>, fumetto::Error> {
        let (Some(player), Some(scene)) = (&mut self.player, project.in_style(preset)) else {
            return Ok(None);
        };
        let Some((wish, _)) = &self.shown else { return Ok(None) };
        let height = (WIDTH * wish.size[1]).div_ceil(wish.size[0].max(1)).clamp(1, 4 * WIDTH);
        let shot = Shot { camera: wish.camera.clone(), size: [WIDTH, height], antialias: 2 };
        let render = &self.gallery.render;
        let canvas = self.gallery.canvases.entry(preset).or_insert_with(|| Canvas::new(render.clone()));
        let view = canvas.texture(shot.size).create_view(&wgpu::TextureViewDescriptor::default());
        let scene = before_grey(scene);
        self.engine.draw_as(player, scene, Box::new(project.files.clone()), &shot, &view)?;
        let picture = canvas.show();
        let wake = self.wake.clone();
        self.pace.begin(&self.engine.gpu().queue, false, move || wake.request_repaint());
        self.wake.request_repaint();
        Ok(picture)
    }
}
