//! What a crash would cost, and what one has left.

use egui::Context;

use super::App;
use crate::autosave::{EVERY, Left};
use crate::project::{Origin, Project};

/// What becomes of what was left.
#[derive(Clone, Copy)]
enum Choice {
    Recover,
    ThrowAway,
    /// It is offered again at the next start.
    Later,
}

impl App {
    /// Keeps what is not saved, for the case of a crash.
    pub(super) fn keep_safe(&mut self, ctx: &Context) {
        if !self.project.document().is_changed() || self.may_quit {
            return self.autosave.forget();
        }
        match self.autosave.keep(&self.project) {
            // Nobody may touch anything until then.
            Ok(wait) => wait.into_iter().for_each(|wait| ctx.request_repaint_after(wait)),
            Err(error) => {
                ctx.request_repaint_after(EVERY);
                self.refusal =
                    Some(format!("what is not saved cannot be kept for the case of a crash: {error:#}"));
            }
        }
    }

    /// Offers what an editor left that ended unexpectedly, one after the other: what is open has to be saved first.
    pub(super) fn recovery_ui(&mut self, ctx: &Context) {
        if self.project.document().is_changed() {
            return;
        }
        let Some(left) = self.left.first() else { return };
        let name = match &left.origin {
            Origin::New => "A scene that was never saved".to_owned(),
            Origin::Example(name) => format!("{name}, begun as an example,"),
            Origin::File(path) => path.display().to_string(),
        };
        let mut choice = None;
        egui::Modal::new(egui::Id::unique("recovery")).show(ctx, |ui| {
            ui.heading("Go on with unsaved work?");
            ui.label(format!("{name} had changes when the editor ended unexpectedly."));
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                let choices = [
                    ("Recover", Choice::Recover),
                    ("Throw away", Choice::ThrowAway),
                    ("Later", Choice::Later),
                ];
                for (name, what) in choices {
                    if ui.button(name).clicked() {
                        choice = Some(what);
                    }
                }
            });
        });
        match choice {
            Some(Choice::Recover) => {
                let left = self.left.remove(0);
                self.recover(left);
            }
            Some(Choice::ThrowAway) => self.left.remove(0).forget(),
            Some(Choice::Later) => self.left.clear(),
            None => {}
        }
    }

    fn recover(&mut self, left: Left) {
        match Project::recovered(&left.origin, left.text.clone()) {
            Ok(project) => {
                self.show(project);
                self.autosave.follow(left);
            }
            // It stays where it is.
            Err(error) => self.refusal = Some(error.to_string()),
        }
    }
}
