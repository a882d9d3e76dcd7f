//! What is measured.

use fumetto::Engine;

use crate::measure::{Budget, Samples};

/// A part of Fumetto whose time grows with some size.
pub(crate) struct Subsystem {
    /// What it is called on the command line and in files.
    pub(crate) name: &'static str,
    /// What one measurement is, for the reader of the report.
    pub(crate) title: &'static str,
    /// What a size counts.
    pub(crate) counted: &'static str,
    /// The sizes of a full run, rising.
    pub(crate) sizes: &'static [u32],
    /// The ways in which it can run that are worth comparing.
    pub(crate) variants: &'static [&'static str],
    pub(crate) measure: Measure,
}

/// Measures some of the variants at a size, one after the other in each round; gives samples in their
/// order.
pub(crate) type Measure = fn(&mut Engine, &[&'static str], u32, Budget) -> anyhow::Result<Vec<Samples>>;
