//! Shapes as operators of PDF.

use kurbo::{PathEl, Point};
use pdf_writer::{
    Content,
    types::{LineCapStyle, LineJoinStyle},
};

use super::super::Shape;

/// Draws a shape, but for its opacity.
pub(super) fn draw(shape: &Shape, content: &mut Content) {
    let [r, g, b] = shape.colour.map(|channel| f32::from(channel) / 255.0);
    match shape.stroke_px {
        None => {
            content.set_fill_rgb(r, g, b);
            trace(shape, content);
            content.fill_nonzero();
        }
        Some(width) => {
            content.set_stroke_rgb(r, g, b).set_line_width(width as f32);
            content.set_line_cap(LineCapStyle::RoundCap).set_line_join(LineJoinStyle::RoundJoin);
            trace(shape, content);
            content.stroke();
        }
    }
}

fn trace(shape: &Shape, content: &mut Content) {
    let mut at = Point::ZERO;
    for element in shape.path.elements() {
        match *element {
            PathEl::MoveTo(to) => drop(content.move_to(to.x as f32, to.y as f32)),
            PathEl::LineTo(to) => drop(content.line_to(to.x as f32, to.y as f32)),
            PathEl::QuadTo(bend, to) => {
                // PDF knows cubics only.
                let (first, second) = (at.lerp(bend, 2.0 / 3.0), to.lerp(bend, 2.0 / 3.0));
                curve(content, [first, second, to]);
            }
            PathEl::CurveTo(first, second, to) => curve(content, [first, second, to]),
            PathEl::ClosePath => drop(content.close_path()),
        }
        at = element.end_point().unwrap_or(at);
    }
}

fn curve(content: &mut Content, places: [Point; 3]) {
    let [first, second, to] = places.map(|place| [place.x as f32, place.y as f32]);
    content.cubic_to(first[0], first[1], second[0], second[1], to[0], to[1]);
}
