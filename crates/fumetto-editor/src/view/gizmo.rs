use egui::{Color32, Painter, Pos2, Rect, Response, Stroke, Ui};
use fumetto_scene::Camera;
use fumetto_scene::edit::{Edit, Path, Value};
use glam::Vec3;

use super::handles::{Handle, rounded, written};
use super::orbit::axes;
use super::overlay::{AXES, Projection};
use crate::request::{Request, Requests};
use crate::selection;

/// How long an arrow is, in points.
const ARROW: f32 = 56.0;

/// How near a pointer takes hold, in points.
const GRIP: f32 = 9.0;

/// Smallest radius that a hand gives, in metres.
const LEAST_RADIUS: f32 = 1e-3;

/// What is being dragged.
#[derive(Clone, Debug, PartialEq)]
enum Grip {
    /// The place itself, in the picture's plane.
    Free(Path),
    /// The place along an axis.
    Along(Path, Vec3),
    /// How far it reaches.
    Radius(Path),
}

/// Moves places of the scene by hand, over the picture.
#[derive(Default)]
pub(crate) struct Gizmo {
    grip: Option<Grip>,
    /// The place that has arrows.
    active: Option<Path>,
}

impl Gizmo {
    /// Whether the pointer holds something, so that the camera stays.
    pub(crate) fn is_held(&self) -> bool {
        self.grip.is_some()
    }

    /// Does what the pointer does with the handles.
    pub(crate) fn steer(
        &mut self,
        ui: &Ui,
        picture: &Response,
        camera: &Camera,
        handles: &[Handle],
        requests: &mut Requests,
    ) {
        let rect = picture.rect;
        let projection = Projection::new(camera, rect);
        let active = handles.iter().find(|handle| Some(&handle.path) == self.active.as_ref());
        if picture.drag_started_by(egui::PointerButton::Primary)
            && let Some(pointer) = ui.input(|input| input.pointer.press_origin())
        {
            self.grip = take_hold(&projection, camera, handles, active, pointer);
            if let Some(Grip::Free(path)) = &self.grip {
                self.active = Some(path.clone());
            }
        }
        if let (Some(grip), true, Some(to)) = (&self.grip, picture.dragged(), picture.interact_pointer_pos())
        {
            let step = Step { from: to - picture.drag_delta(), to };
            if let Some((path, value)) = dragged(grip, &projection, camera, handles, step) {
                requests.drag(path.to_string(), Edit::Set { path: path.clone(), value });
            }
        }
        if let (true, Some(pointer)) = (picture.clicked(), picture.interact_pointer_pos()) {
            let found = found_at(&projection, camera, handles, pointer);
            self.active = found.map(|handle| handle.path.clone());
            if let Some((list, index)) = found.and_then(|handle| selection::element(&handle.path)) {
                requests.push(Request::Select(list.index(index)));
            }
        }
        // Whatever became of the drag: what no finger holds is not held.
        if !ui.input(|input| input.pointer.primary_down()) && self.grip.take().is_some() {
            requests.push(Request::EndGesture);
        }
    }

    /// Draws the handles.
    pub(crate) fn draw(&self, ui: &Ui, rect: Rect, camera: &Camera, handles: &[Handle]) {
        let projection = Projection::new(camera, rect);
        let painter = ui.painter().with_clip_rect(rect);
        let colour = ui.visuals().selection.stroke.color;
        for handle in handles {
            let is_active = Some(&handle.path) == self.active.as_ref();
            draw(&painter, &projection, camera, handle, if is_active { Color32::WHITE } else { colour });
            if is_active {
                draw_arrows(&painter, &projection, camera, handle.at);
            }
        }
    }
}

/// A way on the screen, in points, as a direction in the picture's plane.
pub(super) fn in_plane(camera: &Camera, way: egui::Vec2) -> Vec3 {
    let [right, up, _] = axes(camera);
    way.x * right - way.y * up
}

/// How many metres a point of the screen is, where something is.
pub(super) fn metres_a_point(camera: &Camera, at: Vec3, rect: Rect) -> f32 {
    let [_, _, back] = axes(camera);
    let depth = (Vec3::from(camera.eye) - at).dot(back).max(1e-4);
    2.0 * depth * (0.5 * camera.fov_deg).to_radians().tan() / rect.height().max(1.0)
}

/// Where the tips of the arrows at a place are.
fn tips(projection: &Projection, camera: &Camera, at: Vec3) -> impl Iterator<Item = (Vec3, Color32, Pos2)> {
    let length = ARROW * metres_a_point(camera, at, projection.rect());
    AXES.into_iter()
        .filter_map(move |(axis, colour)| Some((axis, colour, projection.point(at + length * axis)?)))
}

fn take_hold(
    projection: &Projection,
    camera: &Camera,
    handles: &[Handle],
    active: Option<&Handle>,
    pointer: Pos2,
) -> Option<Grip> {
    if let Some(handle) = active {
        let tip = tips(projection, camera, handle.at).find(|(_, _, tip)| tip.distance(pointer) < GRIP);
        if let Some((axis, ..)) = tip {
            return Some(Grip::Along(handle.path.clone(), axis));
        }
        if let Some((radius, metres)) = &handle.radius {
            let middle = projection.point(handle.at)?;
            let ring = metres / metres_a_point(camera, handle.at, projection.rect());
            if (middle.distance(pointer) - ring).abs() < 0.6 * GRIP {
                return Some(Grip::Radius(radius.clone()));
            }
        }
    }
    let distance = |handle: &Handle| distance_to(projection, handle, pointer);
    let nearest = handles.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    (distance(nearest) < GRIP).then(|| Grip::Free(nearest.path.clone()))
}

/// What lies under the pointer: a handle, or else the nearest ball that one stands for.
fn found_at<'a>(
    projection: &Projection,
    camera: &Camera,
    handles: &'a [Handle],
    pointer: Pos2,
) -> Option<&'a Handle> {
    let distance = |handle: &Handle| distance_to(projection, handle, pointer);
    let nearest = handles.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    if distance(nearest) < GRIP {
        return Some(nearest);
    }
    let is_under = |handle: &&Handle| {
        let Some((_, metres)) = &handle.radius else { return false };
        distance(handle) < metres / metres_a_point(camera, handle.at, projection.rect())
    };
    let depth = |handle: &Handle| Vec3::from(camera.eye).distance(handle.at);
    handles.iter().filter(is_under).min_by(|a, b| depth(a).total_cmp(&depth(b)))
}

/// In points; endless behind the camera.
fn distance_to(projection: &Projection, handle: &Handle, pointer: Pos2) -> f32 {
    projection.point(handle.at).map_or(f32::INFINITY, |at| at.distance(pointer))
}

/// How far the pointer has gone since it was heard last.
#[derive(Clone, Copy)]
struct Step {
    from: Pos2,
    to: Pos2,
}

/// What a drag makes of what is held.
fn dragged<'a>(
    grip: &'a Grip,
    projection: &Projection,
    camera: &Camera,
    handles: &[Handle],
    step: Step,
) -> Option<(&'a Path, Value)> {
    let way = step.to - step.from;
    if way == egui::Vec2::ZERO {
        return None;
    }
    let metres = |handle: &Handle| metres_a_point(camera, handle.at, projection.rect());
    let held = |path: &Path| handles.iter().find(|handle| handle.path == *path);
    match grip {
        Grip::Free(path) => {
            let handle = held(path)?;
            Some((path, written(handle.at + metres(handle) * in_plane(camera, way))))
        }
        Grip::Along(path, axis) => {
            let handle = held(path)?;
            let [right, up, _] = axes(camera);
            let on_screen = egui::vec2(axis.dot(right), -axis.dot(up));
            // Along an axis that points at the eye a pointer could move something endlessly far.
            let moved = metres(handle) * way.dot(on_screen) / on_screen.length_sq().max(0.05);
            Some((path, written(handle.at + moved * *axis)))
        }
        Grip::Radius(path) => {
            let reaches = |handle: &&Handle| handle.radius.as_ref().is_some_and(|(radius, _)| radius == path);
            let handle = handles.iter().find(reaches)?;
            let (_, radius) = handle.radius.as_ref()?;
            let middle = projection.point(handle.at)?;
            let grown = radius + metres(handle) * (middle.distance(step.to) - middle.distance(step.from));
            Some((path, Value::Float(rounded(grown.max(LEAST_RADIUS)))))
        }
    }
}

fn draw(painter: &Painter, projection: &Projection, camera: &Camera, handle: &Handle, colour: Color32) {
    let Some(at) = projection.point(handle.at) else { return };
    painter.circle(at, 4.0, colour, Stroke::new(1.0, Color32::from_black_alpha(140)));
    if let Some((_, metres)) = handle.radius {
        let ring = metres / metres_a_point(camera, handle.at, projection.rect());
        painter.circle_stroke(at, ring, Stroke::new(1.0, colour.gamma_multiply(0.5)));
    }
}

fn draw_arrows(painter: &Painter, projection: &Projection, camera: &Camera, at: Vec3) {
    let Some(middle) = projection.point(at) else { return };
    for (_, colour, tip) in tips(projection, camera, at) {
        painter.line_segment([middle, tip], Stroke::new(2.0, colour));
        painter.circle_filled(tip, 5.0, colour);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_grows_away_from_its_middle_wherever_it_is_held() {
        let camera = Camera {
            name: "view".into(),
            eye: [0.0, 0.0, 4.0],
            target: [0.0, 0.0, 0.0],
            up: [0.0, 1.0, 0.0],
            fov_deg: 40.0,
            near: None,
        };
        let rect = Rect::from_min_size(Pos2::ZERO, egui::vec2(200.0, 100.0));
        let projection = Projection::new(&camera, rect);
        let radius: Path = "light[0].radius".parse().expect("a path");
        let place = "light[0].position".parse().expect("a path");
        let handles = [Handle { path: place, at: Vec3::ZERO, radius: Some((radius.clone(), 1.0)) }];
        let grip = Grip::Radius(radius);
        let metres = metres_a_point(&camera, Vec3::ZERO, rect);
        for side in [egui::Vec2::X, -egui::Vec2::X, egui::Vec2::Y, -egui::Vec2::Y] {
            let grown = |from: f32, to: f32| {
                let step = Step { from: rect.center() + from * side, to: rect.center() + to * side };
                let (_, value) = dragged(&grip, &projection, &camera, &handles, step).expect("a radius");
                value.as_float().expect("a number")
            };
            assert!((grown(30.0, 40.0) - f64::from(1.0 + 10.0 * metres)).abs() < 1e-3, "{side:?}");
            assert!(grown(30.0, 20.0) < 1.0, "{side:?}");
        }
    }
}
