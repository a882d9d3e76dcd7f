//! The clock's controls and the bar of frames.

use egui::{Sense, Ui, WidgetInfo};

use crate::clock::{Clock, Pacing};
use crate::commands::Command;
use crate::icons::Icon;
use crate::request::{Request, Requests};
use crate::settings::Settings;
use crate::stage::Stage;

/// How high the bar of frames is, in points.
const BAR_HEIGHT: f32 = 18.0;

pub(crate) fn ui(
    ui: &mut Ui,
    clock: &Clock,
    stage: Option<&Stage>,
    settings: &mut Settings,
    requests: &mut Requests,
) {
    ui.horizontal(|ui| {
        let play = if clock.playing { (Icon::Pause, "Pause") } else { (Icon::Play, "Play") };
        let buttons = [
            (Icon::First, "First frame", Command::FirstFrame),
            (Icon::Previous, "Previous frame", Command::PreviousFrame),
            (play.0, play.1, Command::Play),
            (Icon::Next, "Next frame", Command::NextFrame),
            (Icon::Last, "Last frame", Command::LastFrame),
        ];
        for (icon, name, command) in buttons {
            if icon.button(ui, name).clicked() {
                requests.push(Request::Do(command));
            }
        }
        let [first, last] = clock.range();
        let mut frame = clock.frame();
        let field = ui.add(egui::DragValue::new(&mut frame).range(first..=last));
        if field.on_hover_text("The frame that is shown").changed() {
            requests.push(Request::Seek(frame));
        }
        ui.weak(format!("of {last}, {} a second", clock.fps()));
        ui.toggle_value(&mut settings.looping, "Loop").on_hover_text("Begin anew at the end");
        let mut every = settings.pacing == Pacing::EveryFrame;
        if ui
            .toggle_value(&mut every, "Every frame")
            .on_hover_text("Leave no frame out, however slow")
            .changed()
        {
            settings.pacing = if every { Pacing::EveryFrame } else { Pacing::RealTime };
        }
        bar_ui(ui, clock, stage, requests);
    });
}

fn bar_ui(ui: &mut Ui, clock: &Clock, stage: Option<&Stage>, requests: &mut Requests) {
    let [first, last] = clock.range();
    let size = egui::vec2(ui.available_width(), BAR_HEIGHT);
    let (rect, bar) = ui.allocate_exact_size(size, Sense::click_and_drag());
    bar.widget_info(|| WidgetInfo::slider(true, clock.frame().into(), "Frame"));
    let frames = (last - first) as f32 + 1.0;
    let place = |frame: f32| rect.left() + rect.width() * (frame - first as f32) / frames;
    if let Some(pointer) = bar.interact_pointer_pos().filter(|_| bar.dragged() || bar.clicked()) {
        let share = ((pointer.x - rect.left()) / rect.width()).clamp(0.0, 1.0);
        requests.push(Request::Seek(first + ((share * frames) as u32).min(last - first)));
    }
    let visuals = ui.visuals();
    ui.painter().rect_filled(rect, 3.0, visuals.extreme_bg_color);
    if let Some(shown) = stage.and_then(Stage::frame) {
        let there =
            egui::Rect::from_x_y_ranges(place(shown as f32)..=place(shown as f32 + 1.0), rect.y_range());
        ui.painter().rect_filled(there, 0.0, visuals.weak_text_color());
    }
    let now = egui::Rect::from_x_y_ranges(
        place(clock.frame() as f32)
            ..=place(clock.frame() as f32 + 1.0).max(place(clock.frame() as f32) + 2.0),
        rect.y_range(),
    );
    ui.painter().rect_filled(now, 0.0, visuals.selection.bg_fill);
}
