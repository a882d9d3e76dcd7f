use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};

use super::{Problem, Report, Severity};

impl Report {
    /// The report as rustc would print it: each problem with its line of text, the offending part
    /// underlined, and a help line. `colour` adds ANSI escapes.
    #[must_use]
    pub fn render(&self, colour: bool) -> String {
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        let problems = self.problems.iter().map(|problem| renderer.render(&[self.group(problem)]));
        let mut paragraphs: Vec<String> = problems.collect();
        if self.left_out > 0 {
            paragraphs.push(format!("… and {} more problems", self.left_out));
        }
        paragraphs.join("\n\n")
    }

    fn group<'a>(&'a self, problem: &'a Problem) -> Group<'a> {
        let level = match problem.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let mut group = Group::with_title(level.primary_title(&problem.message).id(problem.code));
        group = match (&problem.span, self.text(&problem.file)) {
            (Some(span), Some(text)) => group.element(
                Snippet::source(text)
                    .path(&problem.file)
                    .annotation(AnnotationKind::Primary.span(span.clone())),
            ),
            _ => group.element(Origin::path(&problem.file)),
        };
        match &problem.help {
            Some(help) => group.element(Level::HELP.message(help)),
            None => group,
        }
    }
}
