//! `fumetto-bench`: milliseconds against size, for every part of Fumetto, so that growth can be read off.
//!
//! ```text
//! subsystem ─▶ scenes of growing size ─▶ rounds of all variants in turn ─▶ medians ─▶ table, CSV, plots
//! ```

mod args;
mod boulder;
mod cloud;
mod cube;
mod draw;
mod edges;
mod flicker;
mod grid;
mod hidden;
mod imported;
mod machine;
mod measure;
mod number;
mod paint;
mod report;
mod scene;
mod shadows;
mod skins;
mod step;
mod strokes;
mod subsystem;
mod surface;
mod volume;
mod vortex;

use anyhow::{Context as _, ensure};
use clap::Parser as _;
use fumetto::{Engine, Gpu};

use args::Args;
use measure::Budget;
use report::{Report, Row, Table};
use subsystem::Subsystem;

/// Everything that is measured, in the order of the report.
const SUBSYSTEMS: [&Subsystem; 14] = [
    &step::STEP,
    &vortex::VORTEX,
    &grid::GRID,
    &surface::SURFACE,
    &volume::VOLUME,
    &imported::IMPORTED,
    &draw::DRAW,
    &edges::EDGES,
    &hidden::HIDDEN,
    &shadows::SHADOWS,
    &skins::SKINS,
    &paint::SPREAD,
    &paint::REVEAL,
    &strokes::STROKES,
];

fn main() -> anyhow::Result<()> {
    let args = Args::parse();
    let chosen = chosen(&args);
    ensure!(!chosen.is_empty(), "`--filter` leaves nothing; there is: {}", all_names().join(", "));
    let mut engine = Engine::new(pollster::block_on(Gpu::headless())?);
    let mut report = Report::new(machine::adapter(&engine.gpu().adapter), machine::describe());
    println!("{}", report.heading());
    for (subsystem, variants) in chosen {
        report.tables.push(measure(&mut engine, subsystem, variants, &args)?);
        // After each, so that whoever stops a long run keeps what is done.
        report.save(&args.out).with_context(|| format!("cannot write into `{}`", args.out.display()))?;
        println!("{}", report.tables[report.tables.len() - 1].markdown());
    }
    println!("The same as files, with plots: {}", args.out.display());
    Ok(())
}

/// The subsystems and variants that the filter leaves.
fn chosen(args: &Args) -> Vec<(&'static Subsystem, Vec<&'static str>)> {
    let kept = SUBSYSTEMS.map(|subsystem| {
        let variants =
            subsystem.variants.iter().copied().filter(|variant| args.keeps(subsystem.name, variant));
        (subsystem, variants.collect::<Vec<_>>())
    });
    kept.into_iter().filter(|(_, variants)| !variants.is_empty()).collect()
}

fn all_names() -> Vec<String> {
    let names = |subsystem: &&Subsystem| {
        let name = subsystem.name;
        subsystem.variants.iter().map(move |variant| format!("{name}/{variant}")).collect::<Vec<_>>()
    };
    SUBSYSTEMS.iter().flat_map(names).collect()
}

fn measure(
    engine: &mut Engine,
    subsystem: &'static Subsystem,
    variants: Vec<&'static str>,
    args: &Args,
) -> anyhow::Result<Table> {
    let budget = if args.quick { Budget::QUICK } else { Budget::FULL };
    let mut rows = Vec::new();
    for size in args.sizes_of(subsystem) {
        eprintln!("measuring {} at {} {} …", subsystem.name, number::thousands(size), subsystem.counted);
        let samples = (subsystem.measure)(engine, &variants, size, budget)
            .with_context(|| format!("{} at {size} {}", subsystem.name, subsystem.counted))?;
        rows.push(Row { size, samples });
    }
    Ok(Table { subsystem, variants, rows })
}
