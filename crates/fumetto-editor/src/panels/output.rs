//! The window for renderings and exports, and those that are under way.

use std::path::{Path, PathBuf};

use egui::{ComboBox, Context, DragValue, Grid, ProgressBar, Ui};

use crate::icons::Icon;
use crate::jobs::{Job, LAYERS, Order, State, Work, name_for};

/// What the window asks for.
pub(crate) enum Asked {
    /// A dialog for the file's name.
    Name(String),
    Start(Order),
}

/// The window, and what is chosen in it.
#[derive(Default)]
pub(crate) struct Output {
    order: Option<Order>,
}

/// What is rendered unless the user says otherwise.
pub(crate) struct Usual<'a> {
    /// Where the scene lies, or would.
    pub(crate) scene: &'a Path,
    pub(crate) frame: u32,
    pub(crate) frames: [u32; 2],
    pub(crate) output: fumetto_scene::Output,
}

impl Output {
    pub(crate) fn open(&mut self, work: Work, usual: &Usual<'_>) {
        self.order = Some(Order {
            work,
            out: name_for(usual.scene, work),
            frame: usual.frame,
            frames: usual.frames,
            size: usual.output.size,
            antialias: usual.output.antialias,
            layers: [false; 5],
            resume: false,
        });
    }

    /// The user has chosen where it goes.
    pub(crate) fn name(&mut self, path: PathBuf) {
        if let Some(order) = &mut self.order {
            order.out = path;
        }
    }

    pub(crate) fn ui(&mut self, ctx: &Context, jobs: &mut Vec<Job>) -> Option<Asked> {
        let order = self.order.as_mut()?;
        let (mut open, mut asked) = (true, None);
        egui::Window::new("Render and export").open(&mut open).resizable(false).show(ctx, |ui| {
            order_ui(ui, order, &mut asked);
            jobs_ui(ui, jobs);
        });
        if !open {
            self.order = None;
        }
        asked
    }
}

fn order_ui(ui: &mut Ui, order: &mut Order, asked: &mut Option<Asked>) {
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
    if ui.button("Start").clicked() {
        *asked = Some(Asked::Start(order.clone()));
    }
}

fn frames_ui(ui: &mut Ui, order: &mut Order) {
    if order.work.is_still() {
        ui.label("Frame");
        ui.add(DragValue::new(&mut order.frame));
    } else {
        ui.label("Frames");
        ui.horizontal(|ui| {
            let [first, last] = &mut order.frames;
            ui.add(DragValue::new(first).range(0..=*last));
            ui.label("to");
            ui.add(DragValue::new(last).range(*first..=u32::MAX));
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
