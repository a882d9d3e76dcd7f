use std::cell::RefCell;

use super::{Problem, Report, Severity, Text};
use crate::text::Place;

/// Most problems of one severity that a report holds. Whoever has more reads only the first, and a
/// million bad particles must not take a minute to list.
const MAX_PROBLEMS: usize = 100;

/// Collects problems while a scene is read, so that no check has to stop at the first.
#[derive(Debug, Default)]
pub(crate) struct Log {
    report: RefCell<Report>,
}

impl Log {
    /// Keeps a text for quotation and gives its index. One read twice is kept once.
    pub(crate) fn add_text(&self, name: &str, text: &str) -> usize {
        let texts = &mut self.report.borrow_mut().texts;
        texts.iter().position(|known| known.name == name && known.text == text).unwrap_or_else(|| {
            texts.push(Text { name: name.to_owned(), text: text.to_owned() });
            texts.len() - 1
        })
    }

    /// Adds a problem at `place`, or without one in the file called `file`. A style that several
    /// objects use is checked for each of them but reported once.
    pub(crate) fn report(
        &self,
        severity: Severity,
        code: &'static str,
        file: &str,
        place: Option<&Place>,
        message: String,
        help: Option<String>,
    ) {
        let report = &mut *self.report.borrow_mut();
        let name = place.and_then(|place| report.texts.get(place.text)).map_or(file, |text| &text.name);
        let problem = Problem {
            severity,
            code,
            message,
            help,
            file: name.to_owned(),
            span: place.map(|place| place.span.clone()),
        };
        if report.count(severity) >= MAX_PROBLEMS {
            report.left_out += 1;
        } else if !report.problems.contains(&problem) {
            report.problems.push(problem);
        }
    }

    pub(crate) fn has_errors(&self) -> bool {
        self.report.borrow().count(Severity::Error) > 0
    }

    /// The report, its problems in the order in which the texts were read and stand.
    pub(crate) fn finish(self) -> Report {
        let mut report = self.report.into_inner();
        let Report { problems, texts, .. } = &mut report;
        problems.sort_by_key(|problem| {
            let text = texts.iter().position(|text| text.name == problem.file);
            (text, problem.span.as_ref().map(|span| span.start))
        });
        report
    }
}
