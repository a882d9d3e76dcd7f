use std::collections::HashMap;

use eframe::egui_wgpu::RenderState;
use egui::TextureId;
use fumetto::Shot;
use fumetto_scene::{Camera, presets};

use super::canvas::Canvas;
use super::{Stage, before_grey, said};
use crate::project::Project;

/// How wide a picture of the gallery is, in pixels.
const WIDTH: u32 = 176;

/// Small pictures of the moment that is shown, in other styles.
pub(super) struct Gallery {
    render: RenderState,
    canvases: HashMap<&'static str, Canvas>,
    /// Which of the presets is drawn next.
    next: usize,
    /// What the pictures show.
    of: Option<Moment>,
}

/// A revision of a project at a frame, as a camera sees it.
#[derive(Clone, Debug, PartialEq)]
struct Moment {
    project: u64,
    revision: u64,
    frame: u32,
    camera: Camera,
}

impl Gallery {
    pub(super) fn new(render: RenderState) -> Self {
        Self { render, canvases: HashMap::new(), next: 0, of: None }
    }
}

impl Stage {
    /// Draws one more picture of the gallery, where the device has nothing else to do.
    pub(crate) fn draw_style(&mut self, project: &Project) -> Option<(&'static str, TextureId)> {
        let (wish, _) = self.shown.as_ref()?;
        if self.pace.is_busy() || !self.is_at_rest() {
            return None;
        }
        let (project_id, revision) = (project.id(), project.document().revision());
        let of = Moment { project: project_id, revision, frame: wish.frame, camera: wish.camera.clone() };
        if self.gallery.of.as_ref() != Some(&of) {
            (self.gallery.of, self.gallery.next) = (Some(of), 0);
            self.failures.gallery = None;
        }
        let preset = presets::names().get(self.gallery.next).copied()?;
        self.gallery.next += 1;
        let picture = self.style_picture(project, preset);
        self.failures.gallery = said(&picture).or(self.failures.gallery.take());
        picture.ok()?.map(|picture| (preset, picture))
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
