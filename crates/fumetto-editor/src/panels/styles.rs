//! The gallery: the scene as it looks in every ready-made style.

use std::collections::HashMap;

use egui::{Color32, Rect, Role, Sense, StrokeKind, TextureId, Ui, WidgetInfo};
use fumetto_scene::edit::{Document, Edit, Path, Table, Value};
use fumetto_scene::presets;

use crate::project::Project;
use crate::request::{Request, Requests};

/// How wide a picture is, in points.
const WIDTH: f32 = 112.0;

/// The gallery's pictures, as far as they are drawn.
#[derive(Default)]
pub(crate) struct Styles {
    pictures: HashMap<&'static str, TextureId>,
}

impl Styles {
    /// The picture of a style is there.
    pub(crate) fn put(&mut self, preset: &'static str, picture: TextureId) {
        self.pictures.insert(preset, picture);
    }

    pub(crate) fn is_full(&self) -> bool {
        self.pictures.len() == presets::names().len()
    }

    pub(crate) fn ui(&self, ui: &mut Ui, project: &Project, requests: &mut Requests) {
        ui.horizontal(|ui| {
            ui.heading("Styles");
            if ui
                .button("Save own…")
                .on_hover_text("Write the scene's style to a file that other scenes can name")
                .clicked()
            {
                requests.push(Request::SaveStyle);
            }
        });
        let style = Path::root().key("style");
        let present = present(project.document());
        let aspect = project
            .scene()
            .map_or(16.0 / 9.0, |scene| scene.output.size[0] as f32 / scene.output.size[1] as f32);
        egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            for group in presets::groups() {
                ui.add_space(6.0);
                ui.weak(group.title);
                ui.horizontal_wrapped(|ui| {
                    for preset in group.presets {
                        if self.preset_ui(ui, preset, aspect, Some(preset.name) == present.as_deref()) {
                            let mut table = Table::new();
                            table.insert("preset".into(), preset.name.into());
                            requests.edit(Edit::Set { path: style.clone(), value: Value::Table(table) });
                        }
                    }
                });
            }
        });
    }

    /// One style; whether it was chosen.
    fn preset_ui(&self, ui: &mut Ui, preset: &presets::Preset, aspect: f32, is_present: bool) -> bool {
        let picture = egui::vec2(WIDTH, WIDTH / aspect.clamp(0.75, 2.0));
        let size = picture + egui::vec2(0.0, 16.0);
        let (rect, tile) = ui.allocate_exact_size(size, Sense::click());
        tile.widget_info(|| WidgetInfo::selected(Role::Button, true, is_present, preset.name));
        let place = Rect::from_min_size(rect.min, picture);
        ui.painter().rect_filled(place, 3.0, ui.visuals().extreme_bg_color);
        if let Some(&texture) = self.pictures.get(preset.name) {
            let all = Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
            ui.painter().image(texture, place, all, Color32::WHITE);
        }
        if is_present || tile.hovered() {
            let visuals = ui.visuals();
            let stroke =
                if is_present { visuals.selection.stroke } else { visuals.widgets.hovered.bg_stroke };
            ui.painter().rect_stroke(place, 3.0, stroke, StrokeKind::Outside);
        }
        let at = egui::pos2(rect.center().x, rect.bottom() - 8.0);
        let font = egui::FontId::proportional(11.0);
        ui.painter().text(at, egui::Align2::CENTER_CENTER, preset.name, font, ui.visuals().text_color());
        tile.on_hover_text(preset.about()).clicked()
    }
}

/// The preset that the scene's style starts from; none where that is a file.
fn present(document: &Document) -> Option<String> {
    let style = Path::root().key("style");
    match document.get(&style.key("preset")) {
        Some(Value::String(name)) => Some(name),
        _ if document.get(&style.key("file")).is_some() => None,
        _ => Some(presets::names()[0].to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_style_out_of_a_file_is_no_preset() {
        let present = |style: &str| present(&Document::open(style).expect("it is short"));
        assert_eq!(present("").as_deref(), Some(presets::names()[0]));
        assert_eq!(present("style = { preset = \"comic\" }").as_deref(), Some("comic"));
        assert_eq!(present("style = { file = \"my.style.toml\" }"), None);
    }
}
