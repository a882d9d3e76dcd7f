use super::At;
use crate::file::{ObjectFile, SolverFile, SourceFile, WallFile};
use crate::limits::MAX_GRID_CELLS;
use crate::{Eddies, Grid, MAX_SUB_STEPS, Object, Source, extent};

/// The box of air, where the file wants one.
pub(super) fn grid(at: &At<'_>, file: &ObjectFile) -> Option<Grid> {
    if file.solver != Some(SolverFile::Grid) {
        let count = file.emitter.as_ref().map_or(0, |emitters| emitters.as_slice().len());
        let sources = (0..count).map(|index| at.key("emitter").item(index).key("source"));
        for unused in std::iter::once(at.key("grid")).chain(sources).filter(At::exists) {
            let message = format!("`{}` does nothing without solver = \"grid\"", unused.name());
            unused.warning("unused-key", message, "leave it out, or write solver = \"grid\"");
        }
        return None;
    }
    let file = file.grid.unwrap_or_default();
    let walls = file.walls;
    Some(Grid {
        bounds: file.bounds.map(|bounds| [bounds.center, bounds.size]),
        cells: file.cells,
        open: [walls.x, walls.y, walls.z].map(|ends| ends.map(|wall| wall == WallFile::Open)),
        confinement: file.confinement,
        eddies: file.eddies.map(|eddies| Eddies {
            count: eddies.count,
            radius: eddies.radius,
            strength: eddies.strength,
        }),
        dissipation: file.dissipation,
        viscosity: file.viscosity,
        residual: file.residual,
    })
}

pub(super) fn source(file: Option<&SourceFile>) -> Source {
    let file = file.copied().unwrap_or_default();
    Source { heat: file.heat, smoke: file.smoke, expansion: file.expansion, secs: file.secs }
}

/// Refuses a box that has too many cells or misses an emitter, and tells of what cannot be.
pub(super) fn fitting_grid(at: &At<'_>, object: &Object, step_secs: f64) {
    let crate::Matter::Smoke(smoke) = &object.matter else { return };
    let (Some(grid), Some(plan)) = (&smoke.grid, smoke.grid_plan(step_secs)) else { return };
    let place = at.key("grid");
    let [x, y, z] = plan.cells;
    if !plan.fits() {
        let message = format!(
            "a grid of {x} x {y} x {z} cells would take {} MB, and has {} million cells; at most {} are allowed",
            plan.bytes() / 1_000_000,
            plan.cell_count() / 1_000_000,
            MAX_GRID_CELLS
        );
        place.key("cells").error(
            "too-many-cells",
            message,
            "lower `cells`, or make the `box` longer and thinner",
        );
    }
    let high = [0, 1, 2].map(|axis: usize| plan.origin[axis] + plan.cells[axis] as f32 * plan.side);
    for (index, emitter) in smoke.emitters.iter().enumerate() {
        let (from, to) = extent(emitter.shape);
        if (0..3).any(|axis| to[axis] < plan.origin[axis] || from[axis] > high[axis]) {
            let message = format!(
                "this emitter lies outside the grid, which reaches from {:?} to {high:?}: nothing moves its smoke",
                plan.origin
            );
            at.key("emitter").item(index).error("emitter-outside", message, "move it, or enlarge the `box`");
        }
        let closed = grid.open.iter().flatten().all(|open| !open);
        if closed && emitter.source.expansion != 0.0 {
            let message = "air cannot expand where all walls are closed".to_owned();
            let key = at.key("emitter").item(index).key("source").key("expansion");
            key.warning("closed-box", message, "open one of the `walls`, or leave `expansion` out");
        }
    }
    if plan.sub_steps == MAX_SUB_STEPS {
        let message = format!(
            "air may move through many cells in a step: it is made in {MAX_SUB_STEPS} sub-steps, and needs more"
        );
        place.warning(
            "step-too-long",
            message,
            "raise `substeps` of [time], or lower `cells` or what moves the air",
        );
    }
}
