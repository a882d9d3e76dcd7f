//! Paint that particles leave on what they touch.

use fumetto_scene::{Scene, SceneText};

use super::{Body, Model, bodies_at, engine};
use crate::{Engine, Extent, Player, gpu::read_buffer, particles::Particle};

/// A level floor of 8 by 8 metres.
const FLOOR: &str = "v -4 0 -4\nv 4 0 -4\nv 4 0 4\nv -4 0 4\nf 4 3 2 1\n";

/// A wall across the way to the right.
const WALL: &str = "v 1 -4 -4\nv 1 4 -4\nv 1 4 4\nv 1 -4 4\nf 4 3 2 1\n";

/// Paint from particles of an emitter with these keys, which a force moves.
fn play(engine: &Engine, (emitter, force): (&str, &str), stain: &str, model: &'static str) -> Player {
    let toml = format!(
        "format = 1\ncamera = {{ eye = [0, 0, 5], target = [0, 0, 0] }}\n\
         time = {{ fps = 24, frames = [0, 1000] }}\n\
         [[object]]\nname = \"ground\"\nkind = \"mesh\"\nmodel = \"a.obj\"\n\
         [[object]]\nname = \"rain\"\nkind = \"smoke\"\nsolver = \"forces\"\nemitter = {{ {emitter} }}\n\
         force = [{force}]\n\
         [[object]]\nname = \"paint\"\nkind = \"paint\"\nstain = {{ from = \"rain\", {stain} }}\n\
         spread = {{ grain = 0, stiffness = 400, subdivisions = 2 }}\n"
    );
    let text = SceneText { name: "test", toml: &toml, ..Default::default() };
    let loaded = Scene::load(&text, &mut |_| Err("there are no styles".into()));
    let (scene, _) = loaded.unwrap_or_else(|report| panic!("{}", report.render(false)));
    engine.play(scene, Box::new(Model(model))).expect("the scene fits")
}

fn stains_at(engine: &Engine, player: &mut Player, frame: u32) -> Vec<Body> {
    let mut bodies = bodies_at(engine, player, frame);
    bodies.retain(|body| body.far > 0.0);
    bodies
}

fn alive_at(engine: &Engine, player: &mut Player, frame: u32) -> usize {
    engine.seek(player, frame).expect("there are no files to miss");
    let plume = player.plumes().next().expect("there is rain");
    let particles: Vec<Particle> =
        read_buffer(engine.gpu(), plume.emissions[0].particles()).expect("the device lives");
    particles.iter().filter(|particle| !particle.is_dead()).count()
}

/// Ten drops over the floor, fast enough to fall through it in one step.
const RAIN: (&str, &str) = (
    "shape = { box = { center = [0, 3, 0], size = [4, 1, 4] } }, bursts = [{ at = 0, count = 10 }], rate = 0, \
     velocity = [0, -20, 0], life = 9, radius = 0.1",
    "",
);

#[test]
fn rain_ends_where_it_lands_and_leaves_a_drop_of_its_size() {
    let engine = engine();
    let mut player = play(&engine, RAIN, "ends = true, size = 2", FLOOR);
    assert_eq!(alive_at(&engine, &mut player, 2), 10, "it is on its way");
    let early = stains_at(&engine, &mut player, 2);
    assert!(early.is_empty(), "{early:?}");
    assert_eq!(alive_at(&engine, &mut player, 30), 0);
    let stains = stains_at(&engine, &mut player, 100);
    assert_eq!(stains.len(), 10);
    for stain in stains {
        assert_eq!(stain.start, stain.end, "it stands where it landed");
        assert!(stain.start[1].abs() < 1e-4, "on the floor: {:?}", stain.start);
        assert!((stain.far - 0.2).abs() < 1e-3 && (stain.near - 0.2).abs() < 1e-3, "{stain:?}");
    }
}

#[test]
fn smoke_goes_on_and_tints_what_it_comes_through() {
    let engine = engine();
    let drift = (
        "shape = { point = { center = [-1, 0, 0] } }, bursts = [{ at = 0, count = 1 }], rate = 0, \
         velocity = [1, 0, 0], life = 9, radius = 0.5",
        "",
    );
    let mut player = play(&engine, drift, "size = 1", WALL);
    assert_eq!(stains_at(&engine, &mut player, 30).len(), 0, "at x = 0.25 it is not there yet");
    // From x = 0.5 to 1.5 the ball touches the wall at 1.
    let stains = stains_at(&engine, &mut player, 150);
    let [stain] = stains[..] else { panic!("one particle, one stain: {stains:?}") };
    assert!((stain.start[0] - 0.5).abs() < 0.06 && (stain.end[0] - 1.5).abs() < 0.06, "{stain:?}");
    assert!((stain.far - 0.5).abs() < 1e-3);
    assert_eq!(alive_at(&engine, &mut player, 150), 1, "and goes on");
}

#[test]
fn what_passes_by_leaves_nothing() {
    let engine = engine();
    let beside = (
        "shape = { point = { center = [-3, 1, 6] } }, bursts = [{ at = 0, count = 1 }], rate = 0, \
         velocity = [5, 0, 0], life = 9, radius = 0.5",
        "",
    );
    let mut player = play(&engine, beside, "", FLOOR);
    assert_eq!(stains_at(&engine, &mut player, 100).len(), 0);
    let above = (beside.0.replace("6]", "0]"), "");
    let mut player = play(&engine, (&above.0, above.1), "", FLOOR);
    assert_eq!(stains_at(&engine, &mut player, 100).len(), 0, "half a metre above the floor");
}

#[test]
fn as_many_stay_as_should_and_the_oldest_give_way() {
    let engine = engine();
    let shower = (
        "shape = { box = { center = [0, 1, 0], size = [6, 0.1, 6] } }, rate = 48, velocity = [0, -8, 0], life = 0.5, \
         radius = 0.05",
        "",
    );
    let mut player = play(&engine, shower, "ends = true, every = 2, most = 40", FLOOR);
    let room = bodies_at(&engine, &mut player, 0).len();
    assert!((40..66).contains(&room), "{room}");
    let early = stains_at(&engine, &mut player, 20).len();
    assert!((8..24).contains(&early), "half of 2 a frame, less those that fall: {early}");
    assert_eq!(stains_at(&engine, &mut player, 400).len(), room);
}

/// Drops of all sizes that gusts blow about.
const GUSTY: (&str, &str) = (
    "shape = { box = { center = [0, 2, 0], size = [4, 1, 4] } }, rate = 60, velocity = [0, -1, 0], life = [1, 3], \
     radius = [0.05, 0.2], radius_over_life = [[0, 0.5], [1, 2]]",
    "{ kind = \"gravity\" }, { kind = \"turbulence\", speed = 0.5, scale = 1 }, { kind = \"drag\", rate = 0.5 }",
);

#[test]
fn whichever_way_time_goes_stains_are_alike() {
    let engine = engine();
    let mut player = play(&engine, GUSTY, "most = 300", FLOOR);
    let mut bytes = |frame| bytemuck::cast_slice::<_, u8>(&bodies_at(&engine, &mut player, frame)).to_vec();
    let once = bytes(60);
    assert!(once != bytes(61));
    assert!(once == bytes(60));
}

#[test]
fn stains_that_are_put_back_go_on() {
    let engine = engine();
    let mut straight = play(&engine, GUSTY, "most = 300, ends = true", FLOOR);
    engine.seek(&mut straight, 40).expect("there are no files to miss");
    let middle = engine.snapshot(&straight, Extent::Whole).expect("the device lives");
    let bytes = |player: &mut Player| bytemuck::cast_slice::<_, u8>(&bodies_at(&engine, player, 60)).to_vec();
    let end = bytes(&mut straight);
    let mut resumed = play(&engine, GUSTY, "most = 300, ends = true", FLOOR);
    engine.recall(&mut resumed, &middle).expect("it is of the same scene");
    assert!(bytes(&mut resumed) == end);
}
