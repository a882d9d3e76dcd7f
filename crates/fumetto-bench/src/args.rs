//! The command line.

use std::path::PathBuf;

use clap::Parser;

use crate::{number::parse_size, subsystem::Subsystem};

/// The largest size of a quick run.
const QUICK_SIZE: u32 = 5_000;

/// Measures milliseconds against size, for every part of Fumetto.
#[derive(Debug, Parser)]
#[command(name = "fumetto-bench")]
pub(crate) struct Args {
    /// Folder for the CSV file, the table and the plots
    #[arg(long, value_name = "DIR", default_value = "out/bench")]
    pub(crate) out: PathBuf,
    /// Few rounds, and sizes up to 5k only: to see that everything works
    #[arg(long)]
    pub(crate) quick: bool,
    /// Sizes in place of every subsystem's own, such as 1k,50k,1M
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_size)]
    sizes: Vec<u32>,
    /// Only what has NAME in its `subsystem/variant`, such as `step` or `draw/body+ink`
    #[arg(long, value_name = "NAME")]
    filter: Option<String>,
}

impl Args {
    /// Whether the filter lets a variant through.
    pub(crate) fn keeps(&self, subsystem: &str, variant: &str) -> bool {
        let name = format!("{subsystem}/{variant}");
        self.filter.as_ref().is_none_or(|filter| name.contains(filter.as_str()))
    }

    /// The sizes to measure, rising.
    pub(crate) fn sizes_of(&self, subsystem: &Subsystem) -> Vec<u32> {
        if self.sizes.is_empty() {
            let wanted = |size: &u32| !self.quick || *size <= QUICK_SIZE;
            return subsystem.sizes.iter().copied().filter(wanted).collect();
        }
        let mut sizes = self.sizes.clone();
        sizes.sort_unstable();
        sizes.dedup();
        sizes
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;
    use crate::draw::DRAW;

    fn parse(line: &str) -> Args {
        Args::try_parse_from(line.split(' ')).unwrap()
    }

    #[test]
    fn quick_leaves_large_sizes_out_unless_they_are_asked_for() {
        assert_eq!(parse("bench --quick").sizes_of(&DRAW), [1_000, 5_000]);
        assert_eq!(parse("bench --quick --sizes 20k,300,20k").sizes_of(&DRAW), [300, 20_000]);
    }

    #[test]
    fn a_filter_goes_by_subsystem_and_variant() {
        let args = parse("bench --filter draw/body+ink");
        assert!(args.keeps("draw", "body+ink") && args.keeps("draw", "body+ink+shadow"));
        assert!(!args.keeps("draw", "body") && !args.keeps("step", "step"));
        assert!(parse("bench").keeps("step", "step"));
    }
}
