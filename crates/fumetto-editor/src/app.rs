//! The window: what is shown where, and what is done about it.

mod desk;
mod leaving;
mod obey;
mod orders;
mod recovery;

use egui::{CentralPanel, Panel, Ui};
use fumetto_scene::edit::Path;

pub(crate) use self::leaving::Goal;
use self::leaving::Leaving;
use crate::autosave::{Autosave, Left};
use crate::clock::Clock;
use crate::commands;
use crate::dialogs::Dialogs;
use crate::examples::EXAMPLES;
use crate::jobs::{Job, State};
use crate::panels::{
    self, inspector::Inspector, output::Output, palette::Palette, styles::Styles, tree::Tree,
};
use crate::project::Project;
use crate::request::{Request, Requests};
use crate::selection;
use crate::settings::Settings;
use crate::stage::Stage;
use crate::view::{Hand, Viewport};

/// Under this name the settings are kept.
const SETTINGS: &str = "settings";

/// The editor.
pub struct App {
    project: Project,
    /// Without a device there is nothing to see, but the text can still be edited.
    stage: Option<Stage>,
    /// The revision of the document that is played.
    played: Option<u64>,
    clock: Clock,
    viewport: Viewport,
    settings: Settings,
    palette: Palette,
    tree: Tree,
    inspector: Inspector,
    /// What the inspector shows.
    selection: Path,
    /// Where the text is to be shown.
    jump: Option<std::ops::Range<usize>>,
    /// What could not be done last.
    refusal: Option<String>,
    requests: Requests,
    styles: Styles,
    output: Output,
    jobs: Vec<Job>,
    dialogs: Dialogs,
    autosave: Autosave,
    /// What editors left that ended unexpectedly.
    left: Vec<Left>,
    leaving: Option<Leaving>,
    /// Whether what is not saved may be lost.
    may_quit: bool,
}

impl App {
    /// Begins with the first example. What is not saved is kept in the folder `unsaved`, and what was left there is
    /// offered again.
    #[must_use]
    pub fn new(creation: &eframe::CreationContext<'_>, unsaved: &std::path::Path) -> Self {
        let settings = creation.storage.and_then(|storage| eframe::get_value(storage, SETTINGS));
        let context = &creation.egui_ctx;
        let stage = creation.wgpu_render_state.clone().map(|render| Stage::new(render, context.clone()));
        Self::with(settings.unwrap_or_default(), stage, unsaved)
    }

    fn with(settings: Settings, stage: Option<Stage>, unsaved: &std::path::Path) -> Self {
        Self {
            project: Project::example(&EXAMPLES[0]).expect("an example is no longer than scenes may be"),
            stage,
            played: None,
            clock: Clock::new(settings.pacing),
            viewport: Viewport::default(),
            settings,
            palette: Palette::default(),
            tree: Tree::default(),
            inspector: Inspector::default(),
            selection: Path::root(),
            jump: None,
            refusal: None,
            requests: Requests::default(),
            styles: Styles::default(),
            output: Output::default(),
            jobs: Vec::new(),
            dialogs: Dialogs::default(),
            autosave: Autosave::new(unsaved),
            left: Left::all(unsaved),
            leaving: None,
            may_quit: false,
        }
    }

    /// Goes on to another scene.
    pub fn show(&mut self, project: Project) {
        if let Some(path) = project.path() {
            self.settings.remember(path);
        }
        self.project = project;
        self.played = None;
        self.refusal = None;
        self.jump = None;
        self.selection = Path::root();
        self.tree = Tree::default();
        self.inspector = Inspector::default();
        self.styles = Styles::default();
        self.output = Output::default();
        self.viewport.forget();
        self.clock = Clock::new(self.settings.pacing);
    }

    /// Whether the picture shows what it should, as fine as it gets.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        let is_played =
            self.played == Some(self.project.document().revision()) || self.project.scene().is_none();
        is_played
            && self.stage.as_ref().is_none_or(|stage| self.viewport.is_settled(stage, self.clock.frame()))
    }

    /// The scene as it would be saved.
    #[must_use]
    pub fn text(&self) -> &str {
        self.project.document().text()
    }

    /// Whether a rendering or an export is under way.
    #[must_use]
    pub fn has_jobs(&self) -> bool {
        self.jobs.iter().any(|job| job.state == State::Running)
    }

    /// The path of what is selected; empty for the whole scene.
    #[must_use]
    pub fn selected(&self) -> String {
        self.selection.to_string()
    }

    /// The frame that is to be seen.
    #[must_use]
    pub fn frame(&self) -> u32 {
        self.clock.frame()
    }

    /// Whether the gallery of styles shows a picture of each.
    #[must_use]
    pub fn has_full_gallery(&self) -> bool {
        self.styles.is_full()
    }

    /// Plays what the document says by now, if it is without fault.
    fn keep_up(&mut self) {
        let revision = self.project.document().revision();
        let (Some(stage), Some(scene)) = (&mut self.stage, self.project.scene()) else { return };
        if self.played != Some(revision) {
            self.played = Some(revision);
            self.clock.set(&scene.time);
            stage.play(scene.clone(), Box::new(self.project.files.clone()));
        }
    }

    /// What is wrong, and what there is to say, where there is anything.
    fn problems_ui(&mut self, ui: &mut Ui) {
        let refusal = self.refusal.as_deref();
        let failures = self.stage.iter().flat_map(Stage::errors);
        let troubles: Vec<&str> = refusal.into_iter().chain(failures).collect();
        let notes = self.stage.as_ref().map_or(&[][..], Stage::notes);
        if troubles.is_empty() && notes.is_empty() && self.project.report().is_empty() {
            return;
        }
        let requests = &mut self.requests;
        Panel::bottom("problems").resizable(true).show(ui, |ui| {
            egui::ScrollArea::vertical().max_height(120.0).auto_shrink([false, true]).show(ui, |ui| {
                panels::problems::ui(ui, &self.project, (&troubles, notes), requests);
            });
        });
    }

    fn panels_ui(&mut self, ui: &mut Ui) {
        self.selection = selection::nearest(self.project.document(), &self.selection);
        let requests = &mut self.requests;
        Panel::top("menu").show(ui, |ui| panels::menu::ui(ui, &self.project, &mut self.settings, requests));
        Panel::bottom("timeline").show(ui, |ui| {
            panels::timeline::ui(ui, &self.clock, self.stage.as_ref(), &mut self.settings, requests);
        });
        if self.settings.tree {
            Panel::left("tree").default_size(210.0).size_range(150.0..=420.0).show(ui, |ui| {
                self.tree.ui(ui, self.project.document(), &self.selection, requests);
            });
        }
        if self.settings.inspector {
            Panel::right("inspector").default_size(320.0).size_range(240.0..=560.0).show(ui, |ui| {
                // What is half typed belongs to one scene.
                ui.push_id(self.project.id(), |ui| {
                    self.inspector.ui(ui, self.project.document(), &self.selection, requests);
                });
            });
        }
        self.problems_ui(ui);
        let requests = &mut self.requests;
        if self.settings.styles {
            Panel::right("styles").default_size(260.0).size_range(160.0..=520.0).show(ui, |ui| {
                let drawn = self.stage.as_mut().and_then(|stage| stage.draw_style(&self.project));
                if let Some((preset, picture)) = drawn {
                    self.styles.put(preset, picture);
                }
                self.styles.ui(ui, &self.project, requests);
            });
        }
        if self.settings.text {
            Panel::bottom("text").resizable(true).default_size(220.0).show(ui, |ui| {
                panels::text::ui(ui, &self.project, &mut self.jump, requests);
            });
        }
        CentralPanel::default().show(ui, |ui| {
            if let Some(stage) = &mut self.stage {
                let moment = (self.clock.frame(), self.clock.playing);
                let (document, selected) = (self.project.document(), &self.selection);
                let hand = Hand { document, selected, requests: &mut self.requests };
                self.viewport.ui(ui, stage, moment, self.settings.navigation, hand);
            }
        });
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        let ctx = ui.ctx().clone();
        for command in commands::pressed(&ctx) {
            self.requests.push(Request::Do(command));
        }
        (self.viewport.grid, self.viewport.times) = (self.settings.grid, self.settings.times);
        (self.clock.pacing, self.clock.looping) = (self.settings.pacing, self.settings.looping);
        let shown = self.stage.as_ref().and_then(Stage::frame);
        self.clock.tick(ctx.input(|input| input.stable_dt), shown);
        self.keep_up();
        self.take_dropped(&ctx);
        self.panels_ui(ui);
        self.palette.ui(&ctx, &mut self.requests);
        self.output_ui(&ctx);
        self.leaving_ui(&ctx);
        self.recovery_ui(&ctx);
        self.hear_dialogs(&ctx);
        for request in self.requests.take() {
            self.answer(request, &ctx);
        }
        self.keep_safe(&ctx);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        eframe::set_value(storage, SETTINGS, &self.settings);
    }
}
