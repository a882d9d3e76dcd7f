//! Going on to another scene, or away altogether, without losing what is not saved.

use std::path::PathBuf;

use egui::{Context, Modal, ViewportCommand};

use super::App;
use crate::examples::EXAMPLES;
use crate::files::Files;
use crate::project::Project;

/// Where to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Goal {
    /// A scene to start from.
    New,
    /// One of the examples.
    Example(usize),
    /// A file.
    File(PathBuf),
    /// The end.
    Quit,
}

/// A goal that waits for what becomes of the changes.
#[derive(Debug)]
pub(super) struct Leaving {
    goal: Goal,
    /// Whether it goes on once the changes are saved.
    saves: bool,
}

impl App {
    /// Goes there; asks first where changes would be lost.
    pub(super) fn leave_for(&mut self, goal: Goal, ctx: &Context) {
        if self.project.document().is_changed() {
            self.leaving = Some(Leaving { goal, saves: false });
        } else {
            self.go(goal, ctx);
        }
    }

    fn go(&mut self, goal: Goal, ctx: &Context) {
        let opened = match goal {
            Goal::New => {
                let text = fumetto_scene::starts::CLOUD.to_owned();
                Project::new("untitled.toml", text, Files::default()).map_err(Into::into)
            }
            Goal::Example(index) => Project::example(&EXAMPLES[index]).map_err(Into::into),
            Goal::File(path) => Project::open(&path),
            Goal::Quit => {
                self.may_quit = true;
                self.autosave.forget();
                return ctx.send_viewport_cmd(ViewportCommand::Close);
            }
        };
        match opened {
            Ok(project) => {
                self.autosave.forget();
                self.show(project);
            }
            Err(error) => self.refusal = Some(format!("{error:#}")),
        }
    }

    /// Asks what becomes of the changes, while somebody wants to leave.
    pub(super) fn leaving_ui(&mut self, ctx: &Context) {
        if ctx.input(|input| input.viewport().close_requested())
            && self.project.document().is_changed()
            && !self.may_quit
        {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.leaving = Some(Leaving { goal: Goal::Quit, saves: false });
        }
        let Some(leaving) = &self.leaving else { return };
        if leaving.saves {
            return self.leave_when_saved(ctx);
        }
        let mut choice = None;
        let shown = Modal::new(egui::Id::unique("leaving")).show(ctx, |ui| {
            ui.heading("Save the changes?");
            ui.label(format!("{} was changed. Without saving, the changes are lost.", self.project.name()));
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                for (name, what) in
                    [("Save", Choice::Save), ("Discard", Choice::Discard), ("Cancel", Choice::Cancel)]
                {
                    if ui.button(name).clicked() {
                        choice = Some(what);
                    }
                }
            });
        });
        match choice {
            Some(Choice::Save) => {
                if let Some(leaving) = &mut self.leaving {
                    leaving.saves = true;
                }
                self.refusal = None;
                self.save_scene(ctx);
            }
            Some(Choice::Discard) => {
                if let Some(Leaving { goal, .. }) = self.leaving.take() {
                    self.go(goal, ctx);
                }
            }
            Some(Choice::Cancel) => self.leaving = None,
            None if shown.should_close() => self.leaving = None,
            None => {}
        }
    }

    fn leave_when_saved(&mut self, ctx: &Context) {
        if self.refusal.is_some() {
            // The disk is full, say: what is not saved is not left.
            self.leaving = None;
        } else if !self.project.document().is_changed()
            && let Some(Leaving { goal, .. }) = self.leaving.take()
        {
            self.go(goal, ctx);
        }
    }
}

#[derive(Clone, Copy)]
enum Choice {
    Save,
    Discard,
    Cancel,
}
