//! Renderings and exports, from the window that asks for them to the program that makes them.

use std::path::{Path, PathBuf};

use egui::Context;

use super::App;
use crate::dialogs::Purpose;
use crate::jobs::{Job, Work};
use crate::panels::output::{Asked, Usual};

impl App {
    /// Opens the window for renderings (`work`) and exports.
    pub(super) fn order(&mut self, work: Work) {
        let Some(scene) = self.project.scene() else { return self.output.open(None) };
        let place = match self.project.path() {
            Some(path) => path.to_owned(),
            None => pictures().unwrap_or_default().join(self.project.name()),
        };
        let (frame, frames, output) = (self.clock.frame(), scene.time.frames, scene.output);
        self.output.open(Some(Usual { work, scene: &place, frame, frames, output }));
    }

    /// The window for renderings and exports, and what is under way.
    pub(super) fn output_ui(&mut self, ctx: &Context) {
        self.jobs.iter_mut().for_each(Job::hear);
        let has_scene = self.project.scene().is_some();
        if has_scene && self.output.waits_for_scene() {
            self.order(Work::Picture);
        }
        match self.output.ui(ctx, has_scene, &mut self.jobs) {
            Some(Asked::Name(name)) => self.ask(Purpose::Output, &name, ctx),
            Some(Asked::Start(order)) => match Job::start(order, &self.project, ctx) {
                Ok(job) => self.jobs.push(job),
                Err(error) => self.refusal = Some(format!("{error:#}")),
            },
            None => {}
        }
    }
}

/// Where pictures of a scene go that lies nowhere.
fn pictures() -> Option<PathBuf> {
    let home = std::env::home_dir().filter(|home| home.is_absolute())?;
    let pictures = home.join("Pictures");
    Some(if Path::is_dir(&pictures) { pictures } else { home })
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;
    use crate::project::Project;
    use crate::settings::Settings;

    #[test]
    fn what_is_made_of_a_scene_that_lies_nowhere_stays() {
        let folder = tempfile::tempdir().unwrap();
        let mut app = App::with(Settings::default(), None, folder.path());
        app.order(Work::Picture);
        let out = app.output.out().unwrap();
        assert!(out.is_absolute() && out.ends_with("cumulus.png"), "{}", out.display());
        assert_eq!(out.parent(), pictures().as_deref());
        let scene = folder.path().join("a.toml");
        app.project.save(&scene).unwrap();
        app.show(Project::open(&scene).unwrap());
        app.order(Work::Picture);
        assert_eq!(app.output.out(), Some(scene.with_extension("png").as_path()));
    }
}
