//! The shadows of clustered lights, against penumbras that are worked out on paper.

use crate::stage::{Files, PX_PER_METRE, Picture, Rgb, SIDE, Stage, style};

/// In the plane z = 0, 16 m wide.
const WALL: &str = "v -8 -8 0\nv 8 -8 0\nv 8 8 0\nv -8 8 0\nf 1 2 3 4\n";

/// One metre before it.
const PLATE: &str = "v -3 -6 1\nv -1 -6 1\nv -1 6 1\nv -3 6 1\nf 1 2 3 4\n";

/// Lights in a cluster, and as many steps of shadow.
const LIGHTS: u8 = 8;

fn grey(step: u8) -> Rgb {
    [16 * step + 32; 3]
}

/// The wall behind the plate in a light with a tone for each step of its shadow; `diffuse` is what it adds where
/// nothing keeps it away.
fn picture(light: &str, diffuse: f32) -> Picture {
    let tone = |step: u8| {
        let [level, ..] = grey(step);
        let from = if step == 0 { 0.0 } else { diffuse * (f32::from(step) - 0.5) / f32::from(LIGHTS) };
        format!("{{ colour = \"#{level:02x}{level:02x}{level:02x}\", from = {from} }}")
    };
    let tones: Vec<_> = (0..=LIGHTS).map(tone).collect();
    let style = style(&[], "")
        .replace("tones = []", &format!("tones = [{}]", tones.join(", ")))
        .replace("shadow = { on = false }", "shadow = { on = true }");
    let stage = Stage { light: light.into(), style, ..Stage::default() };
    let stage =
        stage.mesh("wall", "wall.obj", "").mesh("plate", "plate.obj", "style = { tones = [\"#ff0000\"] }");
    stage.picture_with(Files::default().with("wall.obj", WALL).with("plate.obj", PLATE))
}

/// How far right a pixel shows the wall.
fn metres(x: u32) -> f32 {
    (x as f32 + 0.5 - 0.5 * SIDE as f32) / PX_PER_METRE
}

fn step_at(picture: &Picture, (x, y): (u32, u32)) -> Option<u8> {
    (0..=LIGHTS).find(|step| picture.rgb(x, y) == grey(*step))
}

/// Asserts that shadow fades in all its steps just between two places on the wall, and to the right.
#[track_caller]
fn assert_fades(picture: &Picture, [from, until]: [f32; 2]) {
    let row = SIDE / 2;
    let right_of_plate = (0..SIDE).filter(|x| metres(*x) > -1.1);
    let steps: Vec<(f32, u8)> =
        right_of_plate.map(|x| (metres(x), step_at(picture, (x, row)).expect("a step"))).collect();
    assert!(steps.is_sorted_by_key(|(_, step)| *step), "{steps:?}");
    let pixel = 1.0 / PX_PER_METRE;
    for (x, step) in &steps {
        assert!(*x > from - pixel || *step == 0, "dark before {from}: {step} at {x}");
        assert!(*x < until + pixel || *step == LIGHTS, "lit after {until}: {step} at {x}");
    }
    let mut seen: Vec<u8> = steps.iter().map(|(_, step)| *step).collect();
    seen.dedup();
    // Two of its lights may stand behind each other.
    assert!(seen.len() >= usize::from(LIGHTS), "every light of the cluster tells: {seen:?}");
}

#[test]
fn suns_side_by_side_throw_a_shadow_that_fades() {
    let light =
        format!("kind = \"sun\", direction = [1, 0, -1], cluster = {{ lights = {LIGHTS}, angle = 15 }}");
    let picture = picture(&light, std::f32::consts::FRAC_1_SQRT_2);
    // The plate's edge at x = -1 throws its shadow to the place where the farthest suns' rays come.
    let reach = |degrees: f32| degrees.to_radians().tan() - 1.0;
    assert_fades(&picture, [reach(45.0 - 15.0), reach(45.0 + 15.0)]);
}

#[test]
fn lamps_side_by_side_throw_a_shadow_that_fades() {
    let light =
        format!("kind = \"point\", position = [-90, 0, 90], cluster = {{ lights = {LIGHTS}, radius = 15 }}");
    let picture = picture(&light, 0.7);
    // From x = -90 ± 15 and z = 90 ± 15 past the edge at x = -1 and z = 1.
    let reach = |x: f32, z: f32| -1.0 + (-1.0 - x) / (z - 1.0);
    assert_fades(&picture, [reach(-75.0, 105.0), reach(-105.0, 75.0)]);
}

#[test]
fn lights_in_one_place_throw_the_shadow_of_one() {
    let sun = "kind = \"sun\", direction = [1, 0, -1]";
    let hard = picture(sun, 0.7);
    let soft = picture(&format!("{sun}, cluster = {{ lights = {LIGHTS}, angle = 0.001 }}"), 0.7);
    let differing = hard.places().filter(|&(x, y)| hard.rgb(x, y) != soft.rgb(x, y)).count();
    // Along the shadow's edge a pixel may lie on either side.
    assert!(differing <= SIDE as usize, "{differing}");
    assert!(hard.count(grey(0)) > 10_000, "there is a shadow");
}

#[test]
fn a_light_beside_a_cluster_changes_none_of_its_shadows() {
    let style = style(&["#101010", "#404040", "#707070", "#a0a0a0", "#d0d0d0"], "")
        .replace("shadow = { on = false }", "shadow = { on = true }");
    let draw = |light: String| {
        let stage = Stage { light, style: style.clone(), ..Stage::default() };
        let stage = stage.mesh("wall", "wall.obj", "");
        let cloud = "soft = 1, extinction = 3, cells = 32, light_cells = 32";
        let stage = stage.volume("cloud", &[[-3.0, 0.0, 3.0, 1.0]], cloud, "");
        stage.picture_with(Files::default().with("wall.obj", WALL))
    };
    let cluster = "kind = \"sun\", direction = [1, 0, -1], cluster = { lights = 4, angle = 5 }";
    let alone = draw(cluster.to_owned());
    let beside = draw(format!("kind = \"sun\", direction = [1, 0, -1], intensity = 0 }}, {{ {cluster}"));
    assert!(alone.colours().len() > 3, "the cloud's shadow fades");
    let differing = alone.places().filter(|&(x, y)| alone.rgb(x, y) != beside.rgb(x, y)).count();
    assert_eq!(differing, 0);
}
