//! Small pictures beside names, drawn as lines so that they are sharp at any size and as quiet as their text.

mod pen;

use std::f32::consts::TAU;

use egui::emath::Rot2;
use egui::{Color32, Painter, Rect, Response, Role, Shape, Stroke, Ui, WidgetInfo, vec2};

use self::pen::Pen;

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Icon {
    Scene,
    Camera,
    Sun,
    Point,
    Smoke,
    Cloud,
    Mesh,
    Volume,
    Paint,
    Emitter,
    Force,
    Stroke,
    Copy,
    Dot,
    Eye,
    Closed,
    Reset,
    Plus,
    Cross,
    Up,
    Down,
    First,
    Previous,
    Play,
    Pause,
    Next,
    Last,
}

impl Icon {
    /// For an object of this kind.
    pub(crate) fn of_object(kind: &str) -> Self {
        match kind {
            "smoke" => Self::Smoke,
            "cloud" => Self::Cloud,
            "mesh" => Self::Mesh,
            "volume" => Self::Volume,
            "paint" => Self::Paint,
            _ => Self::Dot,
        }
    }

    /// For a light or a part of an object, by what it is called.
    pub(crate) fn of_part(name: &str) -> Self {
        match name {
            "Sun" => Self::Sun,
            "Point" => Self::Point,
            "Emitter" => Self::Emitter,
            "Drop" | "Pour" => Self::Paint,
            "Brush stroke" => Self::Stroke,
            "Copy" => Self::Copy,
            "Particle" | "Metamorphosis" => Self::Dot,
            _ => Self::Force,
        }
    }

    /// Draws it in the middle of `rect`.
    pub(crate) fn paint(self, painter: &Painter, rect: Rect, colour: Color32) {
        let side = 14.0_f32.min(rect.height());
        let rect = Rect::from_center_size(rect.center(), vec2(side, side));
        let pen = Pen { painter, rect, stroke: Stroke::new(1.2, colour) };
        match self {
            Self::Scene | Self::Camera | Self::Sun | Self::Point => self.view(&pen),
            Self::Smoke | Self::Cloud | Self::Mesh | Self::Volume | Self::Paint => self.object(&pen),
            Self::Emitter | Self::Force | Self::Stroke | Self::Copy | Self::Dot => self.part(&pen),
            Self::First | Self::Previous | Self::Play | Self::Pause | Self::Next | Self::Last => {
                self.time(&pen);
            }
            _ => self.sign(&pen),
        }
    }

    /// The scene and what it is seen by.
    fn view(self, pen: &Pen<'_>) {
        match self {
            Self::Scene => {
                pen.line(&[[0.1, 0.2], [0.9, 0.2], [0.9, 0.8], [0.1, 0.8], [0.1, 0.2]]);
                pen.line(&[[0.1, 0.7], [0.38, 0.45], [0.55, 0.62], [0.7, 0.5], [0.9, 0.7]]);
            }
            Self::Camera => {
                pen.line(&[[0.08, 0.28], [0.62, 0.28], [0.62, 0.74], [0.08, 0.74], [0.08, 0.28]]);
                pen.line(&[[0.62, 0.46], [0.92, 0.3], [0.92, 0.72], [0.62, 0.56]]);
            }
            Self::Sun => {
                pen.circle([0.5, 0.5], 0.2);
                pen.rays(8, 0.32, 0.47);
            }
            Self::Point => {
                pen.disc([0.5, 0.5], 0.14);
                pen.rays(4, 0.28, 0.46);
            }
            _ => {}
        }
    }

    /// What an object is.
    fn object(self, pen: &Pen<'_>) {
        match self {
            Self::Smoke => {
                pen.arc([0.36, 0.7], 0.2, 0.1, 0.85);
                pen.arc([0.62, 0.5], 0.2, -0.35, 0.5);
                pen.circle([0.44, 0.22], 0.13);
            }
            Self::Cloud => pen.cloud(),
            Self::Mesh => {
                pen.line(&[
                    [0.5, 0.06],
                    [0.88, 0.27],
                    [0.88, 0.72],
                    [0.5, 0.94],
                    [0.12, 0.72],
                    [0.12, 0.27],
                    [0.5, 0.06],
                ]);
                pen.line(&[[0.12, 0.27], [0.5, 0.49], [0.88, 0.27]]);
                pen.line(&[[0.5, 0.49], [0.5, 0.94]]);
            }
            Self::Volume => {
                for y in [0.22, 0.5, 0.78] {
                    for x in [0.22, 0.5, 0.78] {
                        pen.disc([x, y], if x == y { 0.1 } else { 0.06 });
                    }
                }
            }
            Self::Paint => pen.drop(),
            _ => {}
        }
    }

    /// What an object has.
    fn part(self, pen: &Pen<'_>) {
        match self {
            Self::Emitter => {
                pen.line(&[[0.28, 0.92], [0.36, 0.66], [0.64, 0.66], [0.72, 0.92]]);
                for at in [[0.5, 0.44], [0.3, 0.24], [0.7, 0.24], [0.5, 0.1]] {
                    pen.disc(at, 0.07);
                }
            }
            Self::Force => {
                pen.line(&[[0.1, 0.5], [0.88, 0.5]]);
                pen.line(&[[0.62, 0.26], [0.88, 0.5], [0.62, 0.74]]);
            }
            Self::Stroke => {
                pen.line(&[[0.06, 0.7], [0.25, 0.42], [0.42, 0.38], [0.55, 0.6], [0.7, 0.62], [0.94, 0.26]]);
            }
            Self::Copy => {
                pen.line(&[[0.12, 0.12], [0.62, 0.12], [0.62, 0.62], [0.12, 0.62], [0.12, 0.12]]);
                pen.line(&[[0.62, 0.38], [0.88, 0.38], [0.88, 0.88], [0.38, 0.88], [0.38, 0.62]]);
            }
            Self::Dot => pen.circle([0.5, 0.5], 0.2),
            _ => {}
        }
    }

    /// What a click does.
    fn sign(self, pen: &Pen<'_>) {
        match self {
            Self::Eye => {
                pen.lids();
                pen.disc([0.5, 0.5], 0.15);
            }
            Self::Closed => {
                pen.line(&[[0.06, 0.46], [0.26, 0.6], [0.5, 0.66], [0.74, 0.6], [0.94, 0.46]]);
                for [a, b] in
                    [[[0.26, 0.6], [0.2, 0.74]], [[0.5, 0.66], [0.5, 0.82]], [[0.74, 0.6], [0.8, 0.74]]]
                {
                    pen.line(&[a, b]);
                }
            }
            Self::Reset => {
                pen.arc([0.5, 0.54], 0.36, -0.4, 0.3);
                pen.line(&[[0.22, 0.06], [0.22, 0.34], [0.5, 0.34]]);
            }
            Self::Plus => {
                pen.line(&[[0.5, 0.12], [0.5, 0.88]]);
                pen.line(&[[0.12, 0.5], [0.88, 0.5]]);
            }
            Self::Cross => {
                pen.line(&[[0.2, 0.2], [0.8, 0.8]]);
                pen.line(&[[0.2, 0.8], [0.8, 0.2]]);
            }
            Self::Up => pen.line(&[[0.2, 0.64], [0.5, 0.32], [0.8, 0.64]]),
            Self::Down => pen.line(&[[0.2, 0.36], [0.5, 0.68], [0.8, 0.36]]),
            _ => {}
        }
    }

    /// The clock's controls.
    fn time(self, pen: &Pen<'_>) {
        match self {
            Self::First => {
                pen.bar(0.14);
                pen.triangle(0.9, 0.28);
            }
            Self::Previous => pen.triangle(0.76, 0.24),
            Self::Play => pen.triangle(0.16, 0.92),
            Self::Pause => {
                pen.bar(0.22);
                pen.bar(0.62);
            }
            Self::Next => pen.triangle(0.24, 0.76),
            Self::Last => {
                pen.triangle(0.1, 0.72);
                pen.bar(0.72);
            }
            _ => {}
        }
    }

    /// A button with this on it.
    pub(crate) fn button(self, ui: &mut Ui, name: &str) -> Response {
        let button = ui.add(egui::Button::new("").min_size(vec2(24.0, 20.0)));
        button.widget_info(|| WidgetInfo::labeled(Role::Button, ui.is_enabled(), name));
        let colour = ui.style().interact(&button).text_color();
        self.paint(ui.painter(), button.rect.shrink(4.0), colour);
        button.on_hover_text(name)
    }

    /// The triangle before what folds, between pointing at the name (0) and down (1).
    pub(crate) fn fold(painter: &Painter, rect: Rect, openness: f32, colour: Color32) {
        let turn = Rot2::from_angle(0.25 * TAU * openness);
        let r = 0.5 * rect.width();
        let points = [vec2(-0.5 * r, -r), vec2(0.7 * r, 0.0), vec2(-0.5 * r, r)];
        let points = points.map(|offset| rect.center() + turn * offset).to_vec();
        painter.add(Shape::convex_polygon(points, colour, Stroke::NONE));
    }
}
