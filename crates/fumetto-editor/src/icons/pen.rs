//! What icons are drawn with.

use std::f32::consts::TAU;

use egui::{Painter, Pos2, Rect, Shape, Stroke, vec2};

/// Draws in a square with sides of 1.
pub(super) struct Pen<'a> {
    pub(super) painter: &'a Painter,
    pub(super) rect: Rect,
    pub(super) stroke: Stroke,
}

impl Pen<'_> {
    fn at(&self, [x, y]: [f32; 2]) -> Pos2 {
        self.rect.min + self.rect.size() * vec2(x, y)
    }

    pub(super) fn line(&self, points: &[[f32; 2]]) {
        let points = points.iter().map(|point| self.at(*point)).collect();
        self.painter.add(Shape::line(points, self.stroke));
    }

    pub(super) fn circle(&self, centre: [f32; 2], radius: f32) {
        self.painter.circle_stroke(self.at(centre), radius * self.rect.width(), self.stroke);
    }

    pub(super) fn disc(&self, centre: [f32; 2], radius: f32) {
        self.painter.circle_filled(self.at(centre), radius * self.rect.width(), self.stroke.color);
    }

    /// A part of a circle, between shares of a turn.
    pub(super) fn arc(&self, [x, y]: [f32; 2], radius: f32, from: f32, to: f32) {
        let points: Vec<_> = (0..=12)
            .map(|i| TAU * (from + (to - from) * i as f32 / 12.0))
            .map(|angle| [x + radius * angle.cos(), y + radius * angle.sin()])
            .collect();
        self.line(&points);
    }

    /// An upright one; `x` is its left side.
    pub(super) fn bar(&self, x: f32) {
        let bar = Rect::from_two_pos(self.at([x, 0.14]), self.at([x + 0.16, 0.86]));
        self.painter.rect_filled(bar, 0.0, self.stroke.color);
    }

    /// Pointing from one place to another, each from left (0) to right (1).
    pub(super) fn triangle(&self, base: f32, tip: f32) {
        let points = [[base, 0.14], [tip, 0.5], [base, 0.86]].map(|point| self.at(point)).to_vec();
        self.painter.add(Shape::convex_polygon(points, self.stroke.color, Stroke::NONE));
    }

    pub(super) fn rays(&self, count: u32, from: f32, to: f32) {
        for i in 0..count {
            let (y, x) = (TAU * i as f32 / count as f32).sin_cos();
            self.line(&[[0.5 + from * x, 0.5 + from * y], [0.5 + to * x, 0.5 + to * y]]);
        }
    }

    pub(super) fn cloud(&self) {
        self.arc([0.27, 0.6], 0.2, 0.25, 0.72);
        self.arc([0.5, 0.42], 0.25, 0.55, 0.93);
        self.arc([0.75, 0.6], 0.19, 0.69, 1.25);
        self.line(&[[0.27, 0.8], [0.75, 0.79]]);
    }

    pub(super) fn drop(&self) {
        self.arc([0.5, 0.64], 0.28, -0.07, 0.57);
        self.line(&[[0.76, 0.52], [0.5, 0.06], [0.24, 0.52]]);
    }

    pub(super) fn lids(&self) {
        let upper = [[0.04, 0.5], [0.25, 0.32], [0.5, 0.25], [0.75, 0.32], [0.96, 0.5]];
        self.line(&upper);
        self.line(&upper.map(|[x, y]| [x, 1.0 - y]));
    }
}
