//! The editor in a window that only tests see.

use std::path::Path;
use std::time::{Duration, Instant};

use egui_kittest::{Harness, kittest::Queryable};
use fumetto_editor::{App, Project};
use tempfile::TempDir;

/// The slowest processor has drawn a picture by then.
const PATIENCE: Duration = Duration::from_secs(60);

/// The editor, just opened.
pub(crate) struct Desk {
    pub(crate) window: Harness<'static, App>,
    /// What is not saved is kept here.
    pub(crate) folder: TempDir,
}

impl Desk {
    pub(crate) fn open() -> Self {
        Self::open_with(tempfile::tempdir().expect("there is room for temporary files"))
    }

    /// The editor, with what another left in `folder`.
    pub(crate) fn open_with(folder: TempDir) -> Self {
        let unsaved = folder.path().to_owned();
        let window = Harness::builder()
            .with_size([1280.0, 800.0])
            .with_max_steps(4)
            .wgpu()
            .build_eframe(|creation| App::new(creation, &unsaved));
        Self { window, folder }
    }

    /// Opens a scene file, as when it is named on the command line.
    pub(crate) fn show(&mut self, scene: &Path) {
        self.window.state_mut().show(Project::open(scene).expect("the scene can be read"));
    }

    /// Lets time pass until something is so.
    pub(crate) fn wait_until(&mut self, what: &str, is_so: impl Fn(&App) -> bool) {
        let start = Instant::now();
        while !is_so(self.window.state()) {
            assert!(start.elapsed() < PATIENCE, "{what} did not happen");
            self.window.step();
        }
        self.window.step();
    }

    /// The picture is there, as fine as it gets.
    pub(crate) fn settle(&mut self) {
        self.wait_until("a finished picture", App::is_settled);
    }

    pub(crate) fn click(&mut self, label: &str) {
        self.window.get_by_label(label).click();
        self.window.run_steps(2);
    }

    /// Opens a menu, and the menus in it, and chooses an entry.
    pub(crate) fn menu(&mut self, path: &[&str]) {
        for entry in path {
            // Entries that open further menus have an arrow behind their name.
            let found = self.window.query_by_label(entry);
            found.unwrap_or_else(|| self.window.get_by_label_contains(entry)).click();
            self.window.run_steps(2);
        }
    }

    /// Clicks at a place of the window.
    pub(crate) fn press(&mut self, pos: egui::Pos2) {
        self.window.hover_at(pos);
        self.window.step();
        for pressed in [true, false] {
            let (button, modifiers) = (egui::PointerButton::Primary, egui::Modifiers::NONE);
            self.window.event(egui::Event::PointerButton { pos, button, pressed, modifiers });
            self.window.step();
        }
        self.window.step();
    }

    /// The pixels of the window, for a person or a comparison.
    pub(crate) fn look(&mut self, name: &str) -> Vec<u8> {
        let image = self.window.render().expect("the window can be drawn");
        if let Some(folder) = std::env::var_os("FUMETTO_LOOK") {
            image.save(Path::new(&folder).join(format!("{name}.png"))).expect("the folder is there");
        }
        image.into_raw()
    }
}
