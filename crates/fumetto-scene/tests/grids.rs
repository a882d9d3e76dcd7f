//! What a scene says about the air of a grid, and what it does not say.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod common;

use common::load;
use fumetto_scene::{Eddies, Grid, GridPlan, Matter, Scene, Smoke, Source};

const START: &str = "format = 1\ncamera = { eye = [0, 1, 6], target = [0, 1, 0] }\n\
    light = [{ kind = \"sun\", direction = [-0.4, -1, -0.3] }]\n\
    [[object]]\nname = \"smoke\"\nkind = \"smoke\"\nsolver = \"grid\"\n";

fn scene(keys: &str, emitter: &str) -> Scene {
    load(&format!("{START}{keys}\n[object.emitter]\nrate = 10\n{emitter}\n")).unwrap().0
}

fn smoke(scene: &Scene) -> &Smoke {
    match &scene.objects[0].matter {
        Matter::Smoke(smoke) => smoke,
        other => panic!("{other:?} is no smoke"),
    }
}

fn plan(keys: &str, emitter: &str) -> GridPlan {
    let scene = scene(keys, emitter);
    let plan = smoke(&scene).grid_plan(1.0 / 24.0).unwrap();
    assert_eq!(scene.requirements()[0].grid.map(|grid| grid.cells), Some(plan.cells));
    plan
}

const POINT: &str = "shape = { point = { center = [0, 0.2, 0] } }";

#[test]
fn every_key_reaches_the_grid() {
    let keys = "grid = { box = { center = [1, 2, 3], size = [4, 5, 6] }, cells = 40, walls = { y = [\"closed\", \
                \"open\"] }, confinement = 1.5, eddies = { count = 7, radius = 0.4, strength = 3 }, \
                dissipation = 0.5, viscosity = 0.01, residual = 0.1 }";
    let emitter = "shape = { point = { center = [1, 2, 3] } }\n\
                   source = { heat = 2, smoke = 0.5, expansion = -3, secs = 0.4 }";
    let scene = scene(keys, emitter);
    let grid = Grid {
        bounds: Some([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]),
        cells: 40,
        open: [[true, true], [false, true], [true, true]],
        confinement: 1.5,
        eddies: Some(Eddies { count: 7, radius: 0.4, strength: 3.0 }),
        dissipation: 0.5,
        viscosity: 0.01,
        residual: 0.1,
    };
    assert_eq!((smoke(&scene).grid, smoke(&scene).vortex), (Some(grid), None));
    let source = Source { heat: 2.0, smoke: 0.5, expansion: -3.0, secs: 0.4 };
    assert_eq!(smoke(&scene).emitters[0].source, source);
}

#[test]
fn cells_are_cubes_in_whole_blocks_that_hold_the_box() {
    for (size, cells, expected) in [
        ([4.0, 2.0, 1.0], 64, [64, 32, 16]),
        ([1.0, 3.0, 2.0], 60, [24, 64, 48]),
        ([1.0, 1.0, 0.01], 9, [16, 16, 8]),
        ([1.0, 0.5, 0.5], 200, [208, 112, 112]),
    ] {
        let [x, y, z] = size;
        let keys =
            format!("grid = {{ box = {{ center = [0, 0.2, 0], size = [{x}, {y}, {z}] }}, cells = {cells} }}");
        let plan = plan(&keys, POINT);
        assert_eq!(plan.cells, expected, "for {size:?}");
        for axis in 0..3 {
            let sides = plan.cells[axis] as f32 * plan.side;
            assert!(sides >= size[axis] * 0.999);
            let low = if axis == 1 { 0.2 - 0.5 * size[1] } else { -0.5 * sides };
            assert!((plan.origin[axis] - low).abs() < 1e-4, "{plan:?}");
        }
        let coarsest = plan.levels().last().unwrap();
        assert!(coarsest.iter().all(|&count| count <= 16), "{coarsest:?} fit a workgroup");
    }
}

#[test]
fn a_box_that_nobody_gave_holds_the_smokes_way() {
    let keys =
        "force = [{ kind = \"wind\", velocity = [1, 0, 0] }, { kind = \"buoyancy\", acceleration = 1 }]";
    let emitter = "shape = { disc = { center = [5, 1, 0], radius = 0.3 } }\nvelocity = [0, 1, 0]\nlife = 4";
    let plan = plan(keys, emitter);
    let high = [0, 1, 2].map(|axis: usize| plan.origin[axis] + plan.cells[axis] as f32 * plan.side);
    assert!(plan.origin[0] < 4.0 && high[0] > 7.0 && high[0] < 12.0, "{plan:?}");
    assert!(plan.origin[1] < 0.7 && high[1] > 5.0 && high[1] < 20.0, "{plan:?}");
}

#[test]
fn quick_air_and_small_cells_take_sub_steps() {
    let grid = "grid = { box = { center = [0, 0.2, 0], size = [1, 1, 1] }, cells = 64 }";
    let at = |speed: u32| plan(grid, &format!("{POINT}\nvelocity = [0, {speed}, 0]")).sub_steps;
    assert_eq!([at(0), at(1), at(4)], [1, 1, 3]);
    let thick = "grid = { box = { center = [0, 0.2, 0], size = [1, 1, 1] }, cells = 64, viscosity = 0.002 }";
    // 0.002 / 24 s over an eighth of a cell's square.
    assert_eq!(plan(thick, POINT).sub_steps, 3);
}

#[test]
fn a_smaller_residual_takes_more_cycles() {
    let at = |residual: f32| plan(&format!("grid = {{ residual = {residual} }}"), POINT).cycles;
    assert_eq!([at(0.2), at(0.04), at(0.02), at(1e-6)], [1, 2, 3, 9]);
}

#[test]
fn the_cost_of_air_is_told_beforehand() {
    let grid = "grid = { box = { center = [0, 0.2, 0], size = [1, 1, 1] }, cells = 256 }";
    let plan = plan(grid, POINT);
    assert!(plan.fits());
    assert_eq!(plan.cell_count(), 1 << 24);
    assert!((1_200_000_000..1_300_000_000).contains(&plan.bytes()), "{}", plan.bytes());

    // No more eddies than there are particles, and what obstacles are in every cell.
    let bytes = |keys: &str, emitter: &str| {
        let scene = load(&format!("{START}{keys}\n[object.emitter]\n{emitter}\n")).unwrap().0;
        scene.requirements()[0].grid.unwrap().bytes()
    };
    let eddying = grid.replace("cells", "eddies = { count = 100, radius = 0.1, strength = 1 }, cells");
    assert_eq!(bytes(&eddying, &format!("count = 300\n{POINT}")), plan.bytes() + 32 * 100);
    assert_eq!(bytes(&eddying, &format!("count = 60\n{POINT}")), plan.bytes() + 32 * 60);
    let wall = "[[object]]\nname = \"wall\"\nkind = \"mesh\"\nmodel = \"wall.obj\"\nobstacle = true";
    assert_eq!(bytes(grid, &format!("count = 60\n{POINT}\n{wall}")), plan.bytes() + (8 << 24));
}
