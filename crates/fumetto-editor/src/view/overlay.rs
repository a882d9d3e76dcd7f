use egui::{Color32, Painter, Pos2, Rect, Stroke};
use fumetto_scene::Camera;
use glam::{Mat4, Vec3, Vec4};

use super::orbit::axes;

/// Lines of the grid on each side of the middle.
const GRID_LINES: i32 = 10;

/// Where points of the scene are in the window.
pub(crate) struct Projection {
    clip_from_world: Mat4,
    rect: Rect,
}

impl Projection {
    pub(crate) fn new(camera: &Camera, rect: Rect) -> Self {
        let [right, up, back] = axes(camera);
        let eye = Vec3::from(camera.eye);
        let view_from_world = Mat4::from_cols(
            Vec4::new(right.x, up.x, back.x, 0.0),
            Vec4::new(right.y, up.y, back.y, 0.0),
            Vec4::new(right.z, up.z, back.z, 0.0),
            Vec4::new(-right.dot(eye), -up.dot(eye), -back.dot(eye), 1.0),
        );
        let aspect = rect.width() / rect.height().max(1.0);
        let half = (0.5 * camera.fov_deg).to_radians().tan();
        // Depth is not needed: w is the distance before the camera.
        let clip_from_view = Mat4::from_cols(
            Vec4::new(1.0 / (half * aspect), 0.0, 0.0, 0.0),
            Vec4::new(0.0, 1.0 / half, 0.0, 0.0),
            Vec4::new(0.0, 0.0, 0.0, -1.0),
            Vec4::ZERO,
        );
        Self { clip_from_world: clip_from_view * view_from_world, rect }
    }

    /// The picture's place in the window.
    pub(super) fn rect(&self) -> Rect {
        self.rect
    }

    /// Where a point is seen; `None` behind the camera.
    pub(crate) fn point(&self, world: Vec3) -> Option<Pos2> {
        let clip = self.clip_from_world * world.extend(1.0);
        (clip.w > 1e-4).then(|| self.place(clip))
    }

    /// A line as far as it lies before the camera.
    pub(crate) fn line(&self, a: Vec3, b: Vec3) -> Option<[Pos2; 2]> {
        const NEAREST: f32 = 1e-2;
        let (mut a, mut b) = (self.clip_from_world * a.extend(1.0), self.clip_from_world * b.extend(1.0));
        if a.w < NEAREST && b.w < NEAREST {
            return None;
        }
        let crossing = (NEAREST - a.w) / (b.w - a.w);
        if a.w < NEAREST {
            a = a.lerp(b, crossing);
        } else if b.w < NEAREST {
            b = a.lerp(b, crossing);
        }
        Some([self.place(a), self.place(b)])
    }

    fn place(&self, clip: Vec4) -> Pos2 {
        let (x, y) = (clip.x / clip.w, clip.y / clip.w);
        self.rect.center() + 0.5 * self.rect.size() * egui::vec2(x, -y)
    }
}

/// The ground's grid, its lines a power of ten metres apart, and the three axes.
pub(crate) fn grid(painter: &Painter, camera: &Camera, rect: Rect) {
    let projection = Projection::new(camera, rect);
    let distance = Vec3::from(camera.eye).distance(camera.target.into());
    let step = 10f32.powf((0.3 * distance).log10().floor());
    let reach = GRID_LINES as f32 * step;
    let faint = Stroke::new(1.0, Color32::from_white_alpha(28));
    for i in -GRID_LINES..=GRID_LINES {
        let at = i as f32 * step;
        let lines = [
            (Vec3::new(at, 0.0, -reach), Vec3::new(at, 0.0, reach)),
            (Vec3::new(-reach, 0.0, at), Vec3::new(reach, 0.0, at)),
        ];
        for (a, b) in lines.into_iter().filter(|_| i != 0) {
            painter.extend(projection.line(a, b).map(|ends| egui::Shape::line_segment(ends, faint)));
        }
    }
    for (axis, colour) in AXES {
        let ends = projection.line(-reach * axis, reach * axis);
        painter.extend(
            ends.map(|ends| egui::Shape::line_segment(ends, Stroke::new(1.0, colour.gamma_multiply(0.6)))),
        );
    }
}

/// The axes and their colours, as most programs have them.
pub(super) const AXES: [(Vec3, Color32); 3] = [
    (Vec3::X, Color32::from_rgb(0xe0, 0x55, 0x60)),
    (Vec3::Y, Color32::from_rgb(0x7a, 0xc2, 0x5a)),
    (Vec3::Z, Color32::from_rgb(0x5a, 0x8c, 0xe6)),
];

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;

    #[test]
    fn what_the_camera_looks_at_is_in_the_middle() {
        let camera = Camera {
            name: "view".into(),
            eye: [3.0, 2.0, 5.0],
            target: [1.0, 1.0, 0.0],
            up: [0.0, 1.0, 0.0],
            fov_deg: 40.0,
            near: None,
        };
        let rect = Rect::from_min_size(Pos2::new(10.0, 20.0), egui::vec2(200.0, 100.0));
        let projection = Projection::new(&camera, rect);
        let middle = projection.point(camera.target.into()).unwrap();
        assert!(middle.distance(rect.center()) < 1e-3);
        let above = projection.point(Vec3::new(1.0, 1.5, 0.0)).unwrap();
        assert!(above.y < middle.y && (above.x - middle.x).abs() < 1e-3);
        assert_eq!(projection.point(Vec3::new(5.0, 3.0, 10.0)), None);
        assert!(projection.line(camera.target.into(), Vec3::new(5.0, 3.0, 10.0)).is_some());
    }
}
