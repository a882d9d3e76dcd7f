//! The figures: a table to read, a CSV file to work with, a plot for each subsystem.

mod plot;
mod records;
mod table;

use std::{fs, path::Path};

use crate::{measure::Samples, subsystem::Subsystem};

/// Everything that was measured, and on what.
pub(crate) struct Report {
    adapter: String,
    machine: String,
    pub(crate) tables: Vec<Table>,
}

/// One subsystem's figures.
pub(crate) struct Table {
    pub(crate) subsystem: &'static Subsystem,
    /// The columns.
    pub(crate) variants: Vec<&'static str>,
    /// Sizes rise.
    pub(crate) rows: Vec<Row>,
}

/// One size, with samples of every variant.
pub(crate) struct Row {
    pub(crate) size: u32,
    pub(crate) samples: Vec<Samples>,
}

impl Report {
    pub(crate) fn new(adapter: String, machine: String) -> Self {
        Self { adapter, machine, tables: Vec::new() }
    }

    /// On what it was measured, as Markdown.
    pub(crate) fn heading(&self) -> String {
        format!("- adapter: {}\n- machine: {}\n", self.adapter, self.machine)
    }

    /// Writes `bench.csv`, `figures.md` and a plot for each subsystem into `folder`.
    pub(crate) fn save(&self, folder: &Path) -> anyhow::Result<()> {
        fs::create_dir_all(folder)?;
        fs::write(folder.join("bench.csv"), records::csv(self)?)?;
        let tables: Vec<_> = self.tables.iter().map(Table::markdown).collect();
        fs::write(folder.join("figures.md"), format!("{}\n{}", self.heading(), tables.join("\n")))?;
        for table in &self.tables {
            fs::write(
                folder.join(format!("{}.svg", table.subsystem.name)),
                plot::svg(table, &self.adapter)?,
            )?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    /// Two variants at two sizes: the first grows linearly, the second not at all.
    pub(super) fn report() -> Report {
        let samples = |ms| {
            let mut samples = Samples::default();
            samples.add(Duration::from_millis(ms));
            samples
        };
        let rows = vec![
            Row { size: 1_000, samples: vec![samples(2), samples(30)] },
            Row { size: 10_000, samples: vec![samples(20), samples(30)] },
        ];
        let variants = vec!["body", "body+ink"];
        let table = Table { subsystem: &crate::draw::DRAW, variants, rows };
        Report { adapter: "Card, of cards".to_owned(), machine: "m".to_owned(), tables: vec![table] }
    }
}
