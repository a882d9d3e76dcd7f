//! Curves: points that are dragged, and lines between them.

use egui::{Pos2, Rect, Response, Role, Sense, Stroke, Ui, WidgetInfo, vec2};
use fumetto_scene::edit::Value;
use fumetto_scene::limits::Limit;

use super::number::{self, Look, number_of};
use super::points::Points;
use super::row;
use super::sheet::{Sheet, Slot};
use crate::icons::Icon;

/// In points.
const HEIGHT: f32 = 84.0;
const MARGIN: f32 = 7.0;
/// How near a point the pointer has to be.
const REACH: f32 = 9.0;

/// What the curve runs over and what it gives.
pub(super) struct Axes {
    pub(super) x: Limit,
    pub(super) x_unit: &'static str,
    pub(super) y: Limit,
    pub(super) y_unit: &'static str,
}

/// A drawing of the curve, and the numbers of the point that was touched last.
pub(super) fn ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>, axes: &Axes) {
    let Some(points) = slot.value.and_then(Points::read) else { return };
    let id = ui.make_persistent_id(("curve", slot.path));
    let mut chosen = ui.data(|data| data.get_temp::<usize>(id)).unwrap_or_default().min(points.0.len() - 1);
    let (rect, plot) =
        ui.allocate_exact_size(vec2(ui.available_width() - 18.0, HEIGHT), Sense::click_and_drag());
    plot.widget_info(|| {
        WidgetInfo::labeled(Role::Group, true, format!("Curve of {}", slot.name.to_lowercase()))
    });
    let scale = Scale::of(ui, &plot, rect, &points, axes);
    if let Some(changed) = hand(ui, &plot, &scale, &points, axes, &mut chosen) {
        match plot.dragged() {
            true => sheet.slide(slot.path, changed.write()),
            false => sheet.set(slot.path, changed.write()),
        }
    }
    paint(ui, rect, &scale, &points, chosen);
    point_ui(ui, sheet, slot, axes, &points, &mut chosen);
    ui.data_mut(|data| data.insert_temp(id, chosen));
    plot.on_hover_text("Drag a point; double click for another, or on one to take it away");
}

/// What the pointer does to the curve.
fn hand(
    ui: &Ui,
    plot: &Response,
    scale: &Scale,
    points: &Points,
    axes: &Axes,
    chosen: &mut usize,
) -> Option<Points> {
    let held = plot.id.with("point");
    let pointer = plot.interact_pointer_pos()?;
    let near = |place: Pos2| points.nearest(|point| scale.place(point).distance(place));
    let found_at = |place: Pos2| near(place).filter(|(_, far)| *far < REACH).map(|(i, _)| i);
    if plot.double_clicked() {
        return match found_at(pointer) {
            Some(i) => points.without(i),
            None => {
                let (changed, i) = points.with(scale.value(pointer), axes);
                *chosen = i;
                Some(changed)
            }
        };
    }
    if plot.clicked() {
        *chosen = found_at(pointer).unwrap_or(*chosen);
    }
    if plot.drag_started() {
        // The pointer has gone some way before that is known.
        let from = ui.input(|input| input.pointer.press_origin()).unwrap_or(pointer);
        ui.data_mut(|data| data.insert_temp(held, found_at(from)));
    }
    let i = ui.data(|data| data.get_temp::<Option<usize>>(held)).flatten();
    let i = i.filter(|i| plot.dragged() && *i < points.0.len())?;
    *chosen = i;
    Some(points.moved(i, scale.value(pointer), axes)).filter(|changed| changed != points)
}

/// Between points of the window and of the curve.
struct Scale {
    rect: Rect,
    x: [f64; 2],
    y: [f64; 2],
}

impl Scale {
    /// Shows all of the curve; it stays as it is while a point is dragged.
    fn of(ui: &Ui, plot: &Response, rect: Rect, points: &Points, axes: &Axes) -> Self {
        let id = plot.id.with("scale");
        let kept = ui.data(|data| data.get_temp::<[f64; 4]>(id)).filter(|_| plot.dragged());
        let [x0, x1, y0, y1] = kept.unwrap_or_else(|| {
            let most = |i: usize, least: f64| points.0.iter().map(|point| point[i]).fold(least, f64::max);
            let least = |i: usize| points.0.iter().map(|point| point[i]).fold(0.0, f64::min);
            let right = if axes.x.max() <= 1.0 { 1.0 } else { 1.15 * most(0, 0.5) };
            let top = if axes.y.max() <= 1.0 { axes.y.max() } else { 1.2 * most(1, 0.5) };
            [0.0, right, least(1), top]
        });
        ui.data_mut(|data| data.insert_temp(id, [x0, x1, y0, y1]));
        Self { rect: rect.shrink(MARGIN), x: [x0, x1], y: [y0, y1] }
    }

    fn place(&self, [x, y]: [f64; 2]) -> Pos2 {
        let share = |value: f64, [from, to]: [f64; 2]| ((value - from) / (to - from)) as f32;
        self.rect.left_bottom() + vec2(share(x, self.x), -share(y, self.y)) * self.rect.size()
    }

    fn value(&self, place: Pos2) -> [f64; 2] {
        let share = (place - self.rect.left_bottom()) / self.rect.size();
        let value =
            |share: f32, [from, to]: [f64; 2]| rounded(from + f64::from(share) * (to - from), to - from);
        [value(share.x, self.x), value(-share.y, self.y)]
    }
}

/// To about a hundredth of what is seen: no hand is more exact.
fn rounded(value: f64, span: f64) -> f64 {
    let step = 10f64.powf(span.log10().floor() - 2.0);
    (value / step).round() * step
}

fn paint(ui: &Ui, rect: Rect, scale: &Scale, points: &Points, chosen: usize) {
    let (painter, visuals) = (ui.painter().with_clip_rect(rect), ui.visuals());
    painter.rect_filled(rect, 3.0, visuals.extreme_bg_color);
    let faint = Stroke::new(1.0, visuals.widgets.noninteractive.bg_stroke.color);
    for share in [0.0, 0.5, 1.0] {
        let y = scale.rect.bottom() - share * scale.rect.height();
        painter.hline(scale.rect.x_range(), y, faint);
    }
    let places: Vec<Pos2> = points.0.iter().map(|point| scale.place(*point)).collect();
    let mut line = places.clone();
    if let (Some(first), Some(last)) = (places.first(), places.last()) {
        line.insert(0, Pos2::new(rect.left(), first.y));
        line.push(Pos2::new(rect.right(), last.y));
    }
    painter.add(egui::Shape::line(line, Stroke::new(1.5, visuals.text_color())));
    for (i, place) in places.into_iter().enumerate() {
        let colour = if i == chosen { visuals.strong_text_color() } else { visuals.text_color() };
        painter.circle(
            place,
            if i == chosen { 4.5 } else { 3.5 },
            colour,
            Stroke::new(1.5, visuals.extreme_bg_color),
        );
    }
    let corner = format!("{}", (100.0 * scale.y[1]).round() / 100.0);
    let font = egui::FontId::proportional(9.5);
    painter.text(
        rect.left_top() + vec2(3.0, 1.0),
        egui::Align2::LEFT_TOP,
        corner,
        font,
        visuals.weak_text_color(),
    );
}

/// The numbers of one point.
fn point_ui(
    ui: &mut Ui,
    sheet: &mut Sheet<'_>,
    slot: &Slot<'_>,
    axes: &Axes,
    points: &Points,
    chosen: &mut usize,
) {
    let Some(point) = points.0.get(*chosen) else { return };
    row::line(ui, |ui| {
        ui.weak(format!("Point {} of {}", *chosen + 1, points.0.len()));
        if row::icon_button(ui, Icon::Plus, "Add a point").clicked() {
            let (changed, i) = points.split(*chosen, axes);
            *chosen = i;
            sheet.set(slot.path, changed.write());
        }
        ui.add_enabled_ui(points.0.len() > 1, |ui| {
            if row::icon_button(ui, Icon::Cross, "Remove the point").clicked()
                && let Some(changed) = points.without(*chosen)
            {
                sheet.set(slot.path, changed.write());
            }
        });
        let value = Value::Array(point.iter().map(|number| Value::Float(*number)).collect());
        let path = slot.path.index(*chosen);
        let width = 0.5 * (ui.available_width() - 18.0 - 4.0);
        for (i, (range, unit, name)) in
            [(axes.x, axes.x_unit, "at"), (axes.y, axes.y_unit, "value")].into_iter().enumerate()
        {
            let name = format!("{} {name}", slot.name);
            let number = value.get(i);
            let path = path.index(i);
            let part = Slot { path: &path, name: &name, kind: slot.kind, value: number, start: &value };
            ui.allocate_ui(vec2(width, row::HEIGHT), |ui| {
                number::changed_ui(ui, &part, &Look::new(range, unit, false), |response, said| {
                    let mut to = *point;
                    to[i] = number_of(said).unwrap_or(to[i]);
                    let changed = points.moved(*chosen, to, axes);
                    sheet.write(response, slot.path, changed.write());
                });
            });
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use fumetto_scene::limits;

    const AXES: Axes = Axes { x: limits::SHARE, x_unit: "", y: limits::FACTOR, y_unit: "" };

    /// What becomes of the points when the pointer goes from one place of the curve to another.
    fn dragged(points: &Points, from: [f64; 2], to: [f64; 2]) -> Points {
        let ctx = egui::Context::default();
        let rect = Rect::from_min_size(Pos2::ZERO, vec2(200.0, 100.0));
        let scale = Scale { rect, x: [0.0, 1.0], y: [0.0, 2.0] };
        let (from, to) = (scale.place(from), scale.place(to));
        let press = egui::Event::PointerButton {
            pos: from,
            button: egui::PointerButton::Primary,
            pressed: true,
            modifiers: egui::Modifiers::NONE,
        };
        let middle = from.lerp(to, 0.5);
        let events = [egui::Event::PointerMoved(from), press]
            .into_iter()
            .chain([middle, to].map(egui::Event::PointerMoved));
        let (mut changed, mut chosen) = (points.clone(), 0);
        for event in events {
            let input = egui::RawInput { events: vec![event], ..egui::RawInput::default() };
            let mut shown = ctx.run_ui(input, |ui| {
                let plot = ui.interact(rect, egui::Id::unique("plot"), Sense::click_and_drag());
                if let Some(moved) = hand(ui, &plot, &scale, &changed, &AXES, &mut chosen) {
                    changed = moved;
                }
            });
            shown.textures_delta.clear();
        }
        changed
    }

    #[test]
    fn only_a_point_that_is_held_is_dragged() {
        let points = Points(vec![[0.0, 1.0], [0.5, 1.0], [1.0, 0.0]]);
        assert_eq!(dragged(&points, [0.3, 1.8], [0.4, 0.2]), points, "nothing is there");
        let moved = dragged(&points, [0.5, 1.0], [0.7, 0.4]);
        assert!((moved.0[1][0] - 0.7).abs() < 0.01 && (moved.0[1][1] - 0.4).abs() < 0.02, "{moved:?}");
        assert_eq!((moved.0[0], moved.0[2]), (points.0[0], points.0[2]));
    }
}
