use egui::{Color32, CornerRadius, Rect, Response, Sense, StrokeKind, Ui, Vec2};
use fumetto_scene::edit::{Document, Path};
use fumetto_scene::{Camera, Output};

use super::{Brush, Gizmo, Handle, Navigation, Orbit, Side, handles_of_selected, overlay};
use crate::request::Requests;
use crate::stage::{Stage, Wish};

/// Where the picture is seen from, and what is drawn over it.
#[derive(Default)]
pub(crate) struct Viewport {
    /// The hand's own camera; without one, the scene's first.
    camera: Option<Camera>,
    pub(crate) grid: bool,
    pub(crate) times: bool,
    gizmo: Gizmo,
    brush: Brush,
    /// Seconds since the hand last moved the camera.
    rest_secs: f32,
}

/// What a hand over the picture changes, and how it asks for that.
pub(crate) struct Hand<'a> {
    pub(crate) document: &'a Document,
    pub(crate) selected: &'a Path,
    pub(crate) requests: &'a mut Requests,
}

/// So long after the last move a picture is drawn fine.
const REST_SECS: f32 = 0.15;

impl Viewport {
    /// The camera that is looked through.
    pub(crate) fn camera(&self, stage: &Stage) -> Option<Camera> {
        self.camera.clone().or_else(|| Some(stage.scene()?.cameras[0].clone()))
    }

    /// Looks through the scene's own camera again.
    pub(crate) fn forget(&mut self) {
        self.camera = None;
    }

    pub(crate) fn look_from(&mut self, stage: &Stage, side: Side) {
        self.move_camera(stage, |orbit| orbit.look_from(side));
    }

    pub(crate) fn frame(&mut self, stage: &Stage, (centre, radius): (glam::Vec3, f32)) {
        let aspect = stage.scene().map_or(1.0, |scene| aspect(&scene.output));
        self.move_camera(stage, |orbit| orbit.frame(centre, radius, aspect));
    }

    /// Whether the picture shows `frame` from here, as fine as it gets.
    pub(crate) fn is_settled(&self, stage: &Stage, frame: u32) -> bool {
        self.camera(stage).is_none_or(|camera| stage.shows(frame, &camera))
    }

    fn move_camera(&mut self, stage: &Stage, moves: impl FnOnce(&mut Orbit<'_>)) {
        let Some(mut camera) = self.camera(stage) else { return };
        moves(&mut Orbit(&mut camera));
        self.camera = Some(camera);
        self.rest_secs = 0.0;
    }

    /// The picture at `frame`, as large as it fits.
    pub(crate) fn ui(
        &mut self,
        ui: &mut Ui,
        stage: &mut Stage,
        (frame, playing): (u32, bool),
        navigation: Navigation,
        hand: Hand<'_>,
    ) -> Response {
        let (room, _) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
        let Some(mut camera) = self.camera(stage) else {
            ui.painter().text(
                room.center(),
                egui::Align2::CENTER_CENTER,
                "No scene to show yet",
                egui::FontId::proportional(16.0),
                ui.visuals().weak_text_color(),
            );
            return ui.interact(room, ui.scope_id().with("picture"), Sense::hover());
        };
        let output = stage.scene().map_or([1, 1], |scene| scene.output.size);
        let rect = fitted(room, output);
        let picture = ui.interact(rect, ui.scope_id().with("picture"), Sense::click_and_drag());
        picture.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Picture"));
        let handles = handles_of_selected(hand.document, hand.selected);
        let is_held = self.steer(ui, &picture, &mut camera, navigation, (&handles, hand));
        let in_motion = playing || is_held || self.rest_secs < REST_SECS;
        if in_motion {
            ui.request_repaint();
        }
        let points = ui.pixels_per_point();
        let size = [rect.width(), rect.height()].map(|side| ((side * points).round() as u32).max(1));
        let wish = Wish { frame, camera: camera.clone(), size, in_motion };
        if let Some(texture) = stage.show(&wish) {
            let all = Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
            ui.painter().image(texture, rect, all, Color32::WHITE);
        }
        let edge = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter().rect_stroke(rect, CornerRadius::ZERO, edge, StrokeKind::Outside);
        if self.grid {
            overlay::grid(&ui.painter().with_clip_rect(rect), &camera, rect);
        }
        self.gizmo.draw(ui, rect, &camera, &handles);
        if self.times {
            self.times_ui(ui, stage, rect);
        }
        picture
    }

    /// Does what the pointer does, with one thing at a time: the brush, a handle or the camera. Whether something of
    /// the scene is held.
    fn steer(
        &mut self,
        ui: &Ui,
        picture: &Response,
        camera: &mut Camera,
        navigation: Navigation,
        (handles, hand): (&[Handle], Hand<'_>),
    ) -> bool {
        let Hand { document, selected, requests } = hand;
        self.rest_secs += ui.input(|input| input.stable_dt).min(0.1);
        let lays =
            !self.gizmo.is_held() && self.brush.steer(ui, picture, camera, (document, selected), requests);
        if !lays {
            self.gizmo.steer(ui, picture, camera, handles, requests);
        }
        let is_held = lays || self.gizmo.is_held();
        if !is_held && navigation.steer(ui, picture, camera) {
            self.camera = Some(camera.clone());
            self.rest_secs = 0.0;
        }
        is_held
    }

    fn times_ui(&self, ui: &Ui, stage: &Stage, rect: Rect) {
        let took =
            stage.took().map_or_else(String::new, |took| format!("{:.1} ms", 1e3 * took.as_secs_f64()));
        let text = match stage.coarseness() {
            1 => took,
            coarseness => format!("{took}, one pixel of {}", coarseness * coarseness),
        };
        let at = rect.left_top() + Vec2::splat(8.0);
        let font = egui::FontId::monospace(12.0);
        let galley = ui.painter().layout_no_wrap(text, font, Color32::WHITE);
        let back = Rect::from_min_size(at, galley.size()).expand(4.0);
        ui.painter().rect_filled(back, CornerRadius::same(3), Color32::from_black_alpha(160));
        ui.painter().galley(at, galley, Color32::WHITE);
    }
}

fn aspect(output: &Output) -> f32 {
    output.size[0] as f32 / output.size[1] as f32
}

/// The largest rectangle of the picture's shape in `room`.
fn fitted(room: Rect, [width, height]: [u32; 2]) -> Rect {
    let picture = egui::vec2(width as f32, height as f32);
    let scale = (room.size() / picture).min_elem();
    Rect::from_center_size(room.center(), scale * picture)
}
