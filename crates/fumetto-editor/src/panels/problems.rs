//! What is wrong with the scene; a click leads to where it is, in the text and in the tree.

use egui::{RichText, Ui};
use fumetto_scene::Severity;

use crate::project::Project;
use crate::request::{Request, Requests};
use crate::selection;

/// The list of problems and of what went wrong otherwise.
pub(crate) fn ui(
    ui: &mut Ui,
    project: &Project,
    (troubles, notes): (&[&str], &[String]),
    requests: &mut Requests,
) {
    let report = project.report();
    for other in troubles {
        ui.colored_label(ui.visuals().error_fg_color, *other);
    }
    for note in notes {
        ui.weak(note);
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
        // What is wrong in a style file is not in the scene's text.
        let span = problem.span.as_ref().filter(|_| problem.file == project.name());
        if let (true, Some(span)) = (entry.clicked(), span) {
            if let Some(path) = project.document().path_at(span.start) {
                requests.push(Request::Select(selection::holder(&path)));
            }
            requests.push(Request::ShowText(span.clone()));
        }
    }
}
