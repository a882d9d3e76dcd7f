//! The figures for people: a Markdown table that lines up in a terminal as well.

use std::fmt::Write as _;

use super::Table;
use crate::number::{growth_exponent, millis, thousands};

impl Table {
    /// Sizes down, variants across; in brackets the growth exponent since the size above.
    pub(crate) fn markdown(&self) -> String {
        let header = [self.subsystem.counted].into_iter().chain(self.variants.iter().copied());
        let mut lines: Vec<Vec<String>> = vec![header.map(str::to_owned).collect()];
        lines.extend((0..self.rows.len()).map(|index| self.line(index)));
        let widths: Vec<_> = (0..lines[0].len())
            .map(|column| lines.iter().map(|line| line[column].len()).max().unwrap_or(0))
            .collect();
        let rule = widths.iter().map(|width| format!("{}:", "-".repeat(width - 1))).collect();
        lines.insert(1, rule);

        let title = self.subsystem.title;
        let mut text = format!("**{}**: {title}; milliseconds, in brackets growth\n\n", self.subsystem.name);
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

#[cfg(test)]
mod tests {
    use crate::report::tests::report;

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
