//! Paint that is poured, by what must be kept.

use bytemuck::{Pod, Zeroable};

use super::{bodies_at, engine, play};
use crate::{Engine, Player, gpu::read_buffer};

/// `Cell` of `cells.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Cell {
    depth: f32,
    fallen: f32,
    state: u32,
    origin: u32,
}

crate::gpu::layout_test!(cells_are_read_back_as_they_are: Cell, "Cell" of "paint/cells" { depth, fallen, state, origin });

/// A level floor of 8 by 8 metres.
const FLOOR: &str = "v -4 0 -4\nv 4 0 -4\nv 4 0 4\nv -4 0 4\nf 4 3 2 1\n";

/// The same, and in the middle of the right half a wall across it, with a gap at one end.
const WALLED: &str = "v -4 0 -4\nv 4 0 -4\nv 4 0 4\nv -4 0 4\nf 4 3 2 1\n\
                      v 1 2 -4\nv 1.5 2 -4\nv 1.5 2 2\nv 1 2 2\nf 8 7 6 5\n";

/// Two steps: high on the left, low on the right.
const STEPS: &str = "v -4 1 -4\nv 0 1 -4\nv 0 1 4\nv -4 1 4\nf 4 3 2 1\n\
                     v 0 0 -4\nv 4 0 -4\nv 4 0 4\nv 0 0 4\nf 8 7 6 5\n";

/// Cells of a quarter of a metre over all of it; what is poured at x = -2 a second long is `volume`.
fn poured(volume: f32, more: &str) -> String {
    format!(
        "pour = {{ at = [-2, 0, 0.1], during = [0, 1], rate = {volume} }}\nspread = {{ subdivisions = 2 }}\n\
         cells = {{ center = [0, 1, 0], size = [8, 8, 8], cell = 0.25, depth = 0.05, {more} }}"
    )
}

fn cells_at(engine: &Engine, player: &mut Player, frame: u32) -> Vec<Cell> {
    engine.seek(player, frame).expect("there are no files to miss");
    read_buffer(engine.gpu(), player.paints.grids[0].states()).expect("the device lives")
}

fn volume(cells: &[Cell]) -> f32 {
    cells.iter().map(|cell| cell.depth * 0.25 * 0.25).sum()
}

fn is_wet(cells: &[Cell], x: f32, z: f32) -> bool {
    let at = |metres: f32| ((metres + 4.0) / 0.25) as usize;
    cells[at(z) * 32 + at(x)].state != 0
}

#[test]
fn no_paint_is_lost_and_cells_spill_until_all_hold_theirs() {
    let engine = engine();
    let mut player = play(&engine, &poured(0.2, "uneven = 0.5, speed = 4"), FLOOR);
    for frame in [12, 24, 400] {
        let cells = cells_at(&engine, &mut player, frame);
        let expected = 0.2 * (frame as f32 / 24.0).min(1.0);
        assert!((volume(&cells) - expected).abs() < 1e-5, "{} should be {expected}", volume(&cells));
        assert!(cells.iter().all(|cell| cell.depth >= 0.0));
    }
    let cells = cells_at(&engine, &mut player, 2000);
    let wet = cells.iter().filter(|cell| cell.state != 0).count() as f32;
    // 0.2 m³ that lie 0.05 m deep cover 64 cells; at the rim they are not full.
    assert!((60.0..100.0).contains(&wet), "{wet}");
}

#[test]
fn paint_goes_round_a_wall_and_not_over_it() {
    let engine = engine();
    let mut player = play(&engine, &poured(6.0, "uneven = 0, speed = 40"), WALLED);
    let cells = cells_at(&engine, &mut player, 1500);
    assert!(!is_wet(&cells, 1.25, 0.0), "the wall is higher than the paint is deep");
    assert!(is_wet(&cells, 1.25, 3.0) && is_wet(&cells, 2.0, 2.5), "there is a gap");
}

#[test]
fn paint_runs_down_steps_and_not_up() {
    let engine = engine();
    let mut player = play(&engine, &poured(1.5, "uneven = 0, speed = 10"), STEPS);
    let cells = cells_at(&engine, &mut player, 600);
    assert!(is_wet(&cells, 0.1, 0.1), "it has come down");
    let fell = cells.iter().filter(|cell| cell.origin != 0).count();
    assert!(fell >= 1, "and told from where");
    let bodies = bodies_at(&engine, &mut player, 600);
    let runs = bodies.iter().filter(|body| body.far > 0.0 && body.start[1] - body.end[1] > 0.9).count();
    assert_eq!(runs, fell, "their volumes reach from the upper step to the lower one");
    let mut player = play(&engine, &poured(0.02, ""), STEPS);
    assert!(!is_wet(&cells_at(&engine, &mut player, 600), 0.1, 0.1), "a little stays where it is");
}

#[test]
fn where_nothing_is_paint_is_gone() {
    let engine = engine();
    let mut player = play(&engine, &poured(30.0, "uneven = 0, speed = 40"), FLOOR);
    let cells = cells_at(&engine, &mut player, 1500);
    assert!(volume(&cells) < 0.06 * 64.0, "what is too much has run over the rim: {}", volume(&cells));
    assert!(volume(&cells) > 0.04 * 64.0, "the rest stays: {}", volume(&cells));
}

#[test]
fn whichever_way_time_goes_paint_runs_alike() {
    let engine = engine();
    let mut player = play(&engine, &poured(0.4, "uneven = 0.6"), STEPS);
    let mut bytes = |frame| bytemuck::cast_slice::<_, u8>(&cells_at(&engine, &mut player, frame)).to_vec();
    let once = bytes(70);
    assert!(once != bytes(71));
    assert!(once == bytes(70));
}
