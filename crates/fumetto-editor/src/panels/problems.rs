//! What is wrong with the scene; a click leads to where it is.

use egui::{RichText, Ui};
use fumetto_scene::{Report, Severity};

use crate::request::{Request, Requests};

/// The list of problems and of what went wrong otherwise.
pub(crate) fn ui(ui: &mut Ui, report: &Report, others: &[&str], requests: &mut Requests) {
    for other in others {
        ui.colored_label(ui.visuals().warn_fg_color, *other);
    }
    for problem in report.problems() {
        let colour = match problem.severity {
            Severity::Error => ui.visuals().error_fg_color,
            Severity::Warning => ui.visuals().warn_fg_color,
        };
        let place = report
            .position(problem)
            .map_or_else(String::new, |(line, _)| format!("{}:{line}: ", problem.file));
        let text = RichText::new(format!("{place}{}", problem.message)).color(colour);
        let entry = ui.add(egui::Label::new(text).sense(egui::Sense::click()).wrap());
        if let Some(help) = &problem.help {
            ui.indent("help", |ui| ui.weak(help));
        }
        if let (true, Some(span)) = (entry.clicked(), &problem.span) {
            requests.push(Request::ShowText(span.clone()));
        }
    }
}
