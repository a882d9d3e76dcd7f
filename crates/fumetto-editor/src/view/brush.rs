use egui::{Key, PointerButton, Pos2, Response, Ui};
use fumetto_scene::Camera;
use fumetto_scene::edit::{Document, Edit, Item, Path, Table, Value};
use glam::Vec3;

use super::gizmo::{in_plane, metres_a_point};
use super::handles::{handles, rounded, written};
use super::overlay::Projection;
use crate::request::{Request, Requests};
use crate::selection;

/// Held down, a drag lays particles.
const KEY: Key = Key::A;

/// So many radii lie between two particles of a chain: near enough to become one body.
const SPACING: f32 = 0.9;

/// Radius of the first particle of a cloud, in metres.
const USUAL_RADIUS: f32 = 0.4;

/// Lays particles into the selected cloud along the pointer's way.
#[derive(Default)]
pub(crate) struct Brush {
    /// Where the last particle of the chain lies.
    last: Option<Vec3>,
}

impl Brush {
    /// Whether a chain is being laid, so that the camera stays.
    pub(crate) fn steer(
        &mut self,
        ui: &Ui,
        picture: &Response,
        camera: &Camera,
        (document, selected): (&Document, &Path),
        requests: &mut Requests,
    ) -> bool {
        let is_held = ui.input(|input| input.key_down(KEY)) && !ui.ctx().text_edit_focused();
        if !is_held || !picture.dragged_by(PointerButton::Primary) {
            if self.last.take().is_some() {
                requests.push(Request::EndGesture);
            }
            return is_held;
        }
        let (Some(list), Some(pointer)) = (list_of(document, selected), picture.interact_pointer_pos())
        else {
            return true;
        };
        let present = handles(document, &list);
        let radius =
            present.last().and_then(|handle| Some(handle.radius.as_ref()?.1)).unwrap_or(USUAL_RADIUS);
        let depth = present.last().map_or(camera.target.into(), |handle| handle.at);
        let projection = Projection::new(camera, picture.rect);
        if let Some(at) = under(&projection, camera, depth, pointer)
            && self.last.is_none_or(|last| last.distance(at) >= SPACING * radius)
        {
            self.last = Some(at);
            let mut particle = Table::new();
            particle.insert("center".into(), written(at));
            particle.insert("radius".into(), Value::Float(rounded(radius)));
            let item = Item::Value(Value::Table(particle));
            let index = document.count(&list);
            requests.drag("chain of particles", Edit::Insert { list, index, item });
        }
        true
    }
}

/// The listed particles of the selected cloud.
fn list_of(document: &Document, selected: &Path) -> Option<Path> {
    let list = selection::object(selected)?.key("particles");
    matches!(document.get(&list), Some(Value::Array(_))).then_some(list)
}

/// The place under the pointer that is as deep as `depth`.
fn under(projection: &Projection, camera: &Camera, depth: Vec3, pointer: Pos2) -> Option<Vec3> {
    let way = pointer - projection.point(depth)?;
    Some(depth + metres_a_point(camera, depth, projection.rect()) * in_plane(camera, way))
}
