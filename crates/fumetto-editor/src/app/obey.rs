//! What requests and commands do.

use egui::Context;
use fumetto_scene::edit::{Document, Edit, Path, Value};

use super::{App, Goal};
use crate::commands::Command;
use crate::dialogs::Purpose;
use crate::jobs::Work;
use crate::request::Request;
use crate::selection;
use crate::view::{ball, handles};

impl App {
    /// Does what a panel asked for.
    pub(super) fn answer(&mut self, request: Request, ctx: &Context) {
        match request {
            Request::Edit { edit, gesture } => {
                self.refusal =
                    self.project.edit(&edit, gesture.as_deref()).err().map(|error| error.to_string());
            }
            Request::EndGesture => self.project.end_gesture(),
            Request::Do(command) => self.obey(command, ctx),
            Request::Select(path) => self.selection = path,
            Request::Leave(goal) => self.leave_for(goal, ctx),
            Request::SaveStyle => self.ask(Purpose::Style, "my.style.toml", ctx),
            Request::Seek(frame) => self.clock.seek(frame),
            Request::ShowText(span) => {
                self.settings.text = true;
                self.jump = Some(span);
            }
        }
    }

    fn obey(&mut self, command: Command, ctx: &Context) {
        match command {
            Command::New => self.leave_for(Goal::New, ctx),
            Command::Open => self.ask(Purpose::Open, "", ctx),
            Command::Save => self.save_scene(ctx),
            Command::SaveAs => self.ask(Purpose::Save, self.project.name(), ctx),
            Command::Render => self.order(Work::Picture),
            Command::Export => self.order(Work::Drawing),
            Command::Undo => self.project.undo(),
            Command::Redo => self.project.redo(),
            Command::Duplicate => self.change_selected(|_, selected| selection::duplicate(selected)),
            Command::Delete => self.change_selected(selection::delete),
            Command::Rename => self.tree.rename(&self.selection),
            Command::Play => self.clock.toggle(),
            Command::PreviousFrame => self.clock.step(-1),
            Command::NextFrame => self.clock.step(1),
            Command::FirstFrame => self.clock.seek(0),
            Command::LastFrame => self.clock.seek(u32::MAX),
            Command::SceneCamera => self.viewport.forget(),
            Command::LookFrom(side) => {
                if let Some(stage) = &self.stage {
                    self.viewport.look_from(stage, side);
                }
            }
            Command::ToggleTree => self.settings.tree ^= true,
            Command::ToggleInspector => self.settings.inspector ^= true,
            Command::ToggleStyles => self.settings.styles ^= true,
            Command::ToggleText => self.settings.text ^= true,
            Command::ToggleGrid => self.settings.grid ^= true,
            Command::ToggleTimes => self.settings.times ^= true,
            Command::ToggleTheme => {
                let dark = ctx.theme() == egui::Theme::Dark;
                ctx.set_theme(if dark { egui::Theme::Light } else { egui::Theme::Dark });
            }
            Command::Palette => self.palette.open(),
            Command::FrameAll => self.look_at(&Path::root().key("object")),
            Command::FrameSelected => self.look_at(&self.selection.clone()),
            Command::KeepView => self.keep_view(),
            Command::Quit => self.leave_for(Goal::Quit, ctx),
        }
    }
}

impl App {
    /// Looks at what lies at `path`.
    fn look_at(&mut self, path: &Path) {
        let found = ball(&handles(self.project.document(), path));
        if let (Some(stage), Some(ball)) = (&self.stage, found) {
            self.viewport.frame(stage, ball);
        }
    }

    /// Makes what is seen the view of the scene's first camera.
    fn keep_view(&mut self) {
        let Some(camera) = self.stage.as_ref().and_then(|stage| self.viewport.camera(stage)) else { return };
        let path = Path::root().key("camera").index(0);
        let place = |metres: [f32; 3]| Value::Array(metres.map(|metres| Value::Float(metres.into())).into());
        let edits = [("eye", camera.eye), ("target", camera.target), ("up", camera.up)];
        let edits = edits.map(|(key, at)| Edit::Set { path: path.key(key), value: place(at) }).into();
        let edit = Edit::All { label: "Put the scene's camera here".into(), edits };
        match self.project.edit(&edit, None) {
            Ok(()) => self.viewport.forget(),
            Err(error) => self.refusal = Some(error.to_string()),
        }
    }

    /// Does to the selected element what `change` says, and selects what it leads to.
    fn change_selected(&mut self, change: impl Fn(&Document, &Path) -> Option<(Edit, Path)>) {
        let Some((edit, next)) = change(self.project.document(), &self.selection) else { return };
        match self.project.edit(&edit, None) {
            Ok(()) => self.selection = next,
            Err(error) => self.refusal = Some(error.to_string()),
        }
    }
}
