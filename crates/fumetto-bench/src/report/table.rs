//! The figures for people: a Markdown table that lines up in a terminal as well.

use std::fmt::Write as _;

use super::{Row, Table};
use crate::{
    measure::{Made, Samples},
    number::{growth_exponent, millis, thousands},
    subsystem::Subsystem,
};

impl Table {
    /// Sizes down, variants across; in brackets the growth exponent since the size above. Below, likewise,
    /// what came of it, where that is told.
    pub(crate) fn markdown(&self) -> String {
        let Subsystem { name, title, .. } = self.subsystem;
        let times = self.lined_up((0..self.rows.len()).map(|index| self.line(index)));
        let mut text = format!("**{name}**: {title}; milliseconds, in brackets growth\n\n{times}");
        let tells = |told: fn(&Samples) -> bool| self.rows.iter().flat_map(|row| &row.samples).any(told);
        if tells(|samples| samples.made.is_some()) {
            let made = self.lined_up(self.rows.iter().map(made_line));
            // Writing to a string cannot fail.
            let _ =
                write!(text, "\n**{name}**: thousands of triangles, and megabytes kept for them\n\n{made}");
        }
        if tells(|samples| samples.flicker.is_some()) {
            let flicker = self.lined_up(self.rows.iter().map(flicker_line));
            let _ = write!(
                text,
                "\n**{name}**: change of lines that motion does not explain, percent\n\n{flicker}"
            );
        }
        text
    }

    /// A header, a rule, and `lines`.
    fn lined_up(&self, lines: impl Iterator<Item = Vec<String>>) -> String {
        let header = [self.subsystem.counted].into_iter().chain(self.variants.iter().copied());
        let mut lines: Vec<Vec<String>> =
            [header.map(str::to_owned).collect()].into_iter().chain(lines).collect();
        let widths: Vec<_> = (0..lines[0].len())
            .map(|column| lines.iter().map(|line| line[column].len()).max().unwrap_or(0))
            .collect();
        let rule = widths.iter().map(|width| format!("{}:", "-".repeat(width - 1))).collect();
        lines.insert(1, rule);

        let mut text = String::new();
        for line in lines {
            for (cell, width) in line.iter().zip(&widths) {
                // Writing to a string cannot fail.
                let _ = write!(text, "| {cell:>width$} ");
            }
            text.push_str("|\n");
        }
        text
    }

    fn line(&self, index: usize) -> Vec<String> {
        let row = &self.rows[index];
        let before = index.checked_sub(1).map(|index| &self.rows[index]);
        let cells = row.samples.iter().enumerate().map(|(variant, samples)| {
            let median = samples.median_ms();
            let growth = before.map_or_else(String::new, |before| {
                let small = (before.size, before.samples[variant].median_ms());
                format!("({:.2})", growth_exponent(small, (row.size, median)))
            });
            format!("{} {growth:<7}", millis(median))
        });
        [thousands(row.size)].into_iter().chain(cells).collect()
    }
}

fn made_line(row: &Row) -> Vec<String> {
    let cells = row.samples.iter().map(|samples| {
        let told = |made: Made| {
            format!("{}, {}", millis(f64::from(made.triangles) / 1e3), millis(made.bytes as f64 / 1e6))
        };
        samples.made.map_or_else(String::new, told)
    });
    [thousands(row.size)].into_iter().chain(cells).collect()
}

fn flicker_line(row: &Row) -> Vec<String> {
    let cells = row.samples.iter();
    let cells = cells.map(|samples| samples.flicker.map_or_else(String::new, |share| millis(100.0 * share)));
    [thousands(row.size)].into_iter().chain(cells).collect()
}

#[cfg(test)]
mod tests {
    use crate::{measure::Made, report::tests::report};

    #[test]
    fn what_came_of_it_has_a_table_of_its_own() {
        let mut report = report();
        report.tables[0].rows[1].samples[0].made = Some(Made { triangles: 81_234, bytes: 2_000_000 });
        let text = report.tables[0].markdown();
        assert!(text.ends_with("| 10,000 | 81.2, 2.00 |          |\n"), "{text}");
    }

    #[test]
    fn a_table_shows_medians_and_growth() {
        let text = report().tables[0].markdown();
        let lines: Vec<_> = text.lines().skip(2).collect();
        assert_eq!(
            lines,
            [
                "|  puffs |         body |     body+ink |",
                "| -----: | -----------: | -----------: |",
                "|  1,000 | 2.00         | 30.0         |",
                "| 10,000 | 20.0 (1.00)  | 30.0 (0.00)  |",
            ]
        );
    }
}
