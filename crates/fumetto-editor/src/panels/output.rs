//! The window for renderings and exports, and those that are under way.

use std::path::{Path, PathBuf};

use egui::{ComboBox, Context, DragValue, Grid, ProgressBar, Ui};

use crate::icons::Icon;
use crate::jobs::{Job, LAST_FRAME, LAYERS, Order, State, Work, name_for};

/// What the window asks for.
pub(crate) enum Asked {
    /// A dialog for the file's name.
    Name(String),
    Start(Order),
}

/// The window, and what is chosen in it.
#[derive(Default)]
pub(crate) struct Output {
    is_open: bool,
    /// None while there is no scene to render.
    order: Option<Order>,
    /// Names that are no whole paths are found from here.
    folder: PathBuf,
}

/// What is rendered unless the user says otherwise.
pub(crate) struct Usual<'a> {
    pub(crate) work: Work,
    /// Where the scene lies, or would.
    pub(crate) scene: &'a Path,
    pub(crate) frame: u32,
    pub(crate) frames: [u32; 2],
    pub(crate) output: fumetto_scene::Output,
}

impl Output {
    /// Without a scene to render it shows what is under way.
    pub(crate) fn open(&mut self, usual: Option<Usual<'_>>) {
        self.is_open = true;
        self.folder =
            usual.as_ref().and_then(|usual| usual.scene.parent()).unwrap_or(Path::new("")).to_owned();
        self.order = usual.map(|usual| Order {
            work: usual.work,
            out: name_for(usual.scene, usual.work),
            frame: usual.frame.min(LAST_FRAME),
            frames: usual.frames.map(|frame| frame.min(LAST_FRAME)),
            size: usual.output.size,
            antialias: usual.output.antialias,
            layers: [false; 5],
            resume: false,
        });
    }

    /// Whether it is open, and there was nothing to render.
    pub(crate) fn waits_for_scene(&self) -> bool {
        self.is_open && self.order.is_none()
    }

    /// Where it goes.
    #[cfg(test)]
    pub(crate) fn out(&self) -> Option<&Path> {
        self.order.as_ref().map(|order| order.out.as_path())
    }

    /// The user has chosen where it goes.
    pub(crate) fn name(&mut self, path: PathBuf) {
        if let Some(order) = &mut self.order {
            order.out = path;
        }
    }

    /// Shows it, with what can be made as long as there is a scene.
    pub(crate) fn ui(&mut self, ctx: &Context, has_scene: bool, jobs: &mut Vec<Job>) -> Option<Asked> {
        let mut asked = None;
        let (order, folder) = (self.order.as_mut().filter(|_| has_scene), &self.folder);
        egui::Window::new("Render and export").open(&mut self.is_open).resizable(false).show(ctx, |ui| {
            match order {
                Some(order) => order_ui(ui, order, folder, &mut asked),
                None => {
                    ui.label(
                        "There is no picture of a scene with errors. They are listed below the picture.",
                    );
                }
            }
            jobs_ui(ui, jobs);
        });
        asked
    }
}

fn order_ui(ui: &mut Ui, order: &mut Order, folder: &Path, asked: &mut Option<Asked>) {
    Grid::new("order").num_columns(2).spacing([12.0, 6.0]).show(ui, |ui| {
        ui.label("What");
        let before = order.work;
        ComboBox::from_id_salt("work").selected_text(order.work.name()).show_ui(ui, |ui| {
            for work in Work::ALL {
                ui.selectable_value(&mut order.work, work, work.name());
            }
        });
        if order.work != before {
            order.out = renamed(&order.out, before, order.work);
        }
        ui.end_row();
        ui.label("Where");
        ui.horizontal(|ui| {
            let mut name = order.out.display().to_string();
            if ui.add(egui::TextEdit::singleline(&mut name).desired_width(300.0)).changed() {
                order.out = name.into();
            }
            if ui.button("Choose…").clicked() {
                let name = order.out.file_name().unwrap_or_default().to_string_lossy().into_owned();
                *asked = Some(Asked::Name(name));
            }
        });
        ui.end_row();
        frames_ui(ui, order);
        picture_ui(ui, order);
    });
    let out = folder.join(&order.out);
    let start = ui.add_enabled(out.is_absolute(), egui::Button::new("Start"));
    if start.on_disabled_hover_text("Choose first where it goes").clicked() {
        *asked = Some(Asked::Start(Order { out, ..order.clone() }));
    }
}

fn frames_ui(ui: &mut Ui, order: &mut Order) {
    if order.work.is_still() {
        ui.label("Frame");
        ui.add(DragValue::new(&mut order.frame).range(0..=LAST_FRAME));
    } else {
        ui.label("Frames");
        ui.horizontal(|ui| {
            let [first, last] = &mut order.frames;
            ui.add(DragValue::new(first).range(0..=*last));
            ui.label("to");
            ui.add(DragValue::new(last).range(*first..=LAST_FRAME));
        });
    }
    ui.end_row();
}

fn picture_ui(ui: &mut Ui, order: &mut Order) {
    if order.work.has_size() {
        ui.label("Size");
        ui.horizontal(|ui| {
            for side in &mut order.size {
                ui.add(DragValue::new(side).range(1..=32_768).suffix(" px"));
            }
        });
        ui.end_row();
    }
    if order.work.is_rendered() {
        ui.label("Smooth edges");
        ui.add(egui::Slider::new(&mut order.antialias, 1..=4))
            .on_hover_text("Samples along each side of a pixel");
        ui.end_row();
    }
    if matches!(order.work, Work::Picture | Work::Sequence) {
        ui.label("Layers too");
        ui.horizontal(|ui| {
            for (name, wanted) in LAYERS.into_iter().zip(&mut order.layers) {
                ui.checkbox(wanted, name);
            }
        });
        ui.end_row();
    }
    if order.work == Work::Sequence {
        ui.label("Go on");
        ui.checkbox(&mut order.resume, "leave pictures alone that are there already");
        ui.end_row();
    }
}

/// The same name for another kind of file.
fn renamed(out: &Path, before: Work, work: Work) -> PathBuf {
    let name = out.display().to_string();
    let stem = name.strip_suffix(before.ending()).map(ToOwned::to_owned);
    stem.map_or_else(|| name_for(out, work), |stem| format!("{stem}{}", work.ending()).into())
}

fn jobs_ui(ui: &mut Ui, jobs: &mut Vec<Job>) {
    let mut dropped = None;
    for (index, job) in jobs.iter_mut().enumerate() {
        ui.separator();
        let name = job.order.out.file_name().unwrap_or_default().to_string_lossy().into_owned();
        ui.horizontal(|ui| match &job.state {
            State::Running => {
                let left = job.left().map_or_else(String::new, |left| format!(", {} s left", left.as_secs()));
                let bar = ProgressBar::new(job.share()).text(format!("{name}{left}")).desired_width(300.0);
                ui.add(bar);
                if ui.button("Stop").clicked() {
                    job.stop();
                }
            }
            State::Done => {
                ui.label(format!("{name} is done"));
                dropped = dropped_by(ui, index).or(dropped);
            }
            State::Stopped => {
                ui.label(format!("{name} was stopped"));
                dropped = dropped_by(ui, index).or(dropped);
            }
            State::Failed(said) => {
                ui.colored_label(ui.visuals().error_fg_color, format!("{name}: {said}"));
                dropped = dropped_by(ui, index).or(dropped);
            }
        });
    }
    if let Some(index) = dropped {
        jobs.remove(index);
    }
}

fn dropped_by(ui: &mut Ui, index: usize) -> Option<usize> {
    Icon::Cross.button(ui, "Take off the list").clicked().then_some(index)
}
