//! The shadows of meshes, against shadows that are worked out on paper.

use std::fmt::Write as _;

use glam::{Vec2, Vec3};

use crate::{
    balls::{self, EYE},
    models::square,
    stage::{CORE, Files, PX_PER_METRE, Picture, Rgb, SIDE, Stage, engine, picture_at, style},
};

pub(crate) const SHADOW: Rgb = [0x40, 0x40, 0x60];
pub(crate) const LIT: Rgb = [0xf0, 0xf0, 0xe0];
const CASTER: Rgb = [0xff, 0, 0];
pub(crate) const RED: &str = "style = { tones = [\"#ff0000\"] }";

/// A sun that shines down to the right.
pub(crate) const SUN: &str = "kind = \"sun\", direction = [1, 0, -1]";

pub(crate) fn two_tones() -> String {
    let tones = "tones = [{ colour = \"#404060\", from = 0 }, { colour = \"#f0f0e0\", from = 0.01 }]";
    style(&[], "").replace("tones = []", tones).replace("shadow = { on = false }", "shadow = { on = true }")
}

/// A wall in the plane z = 0 that goes beyond the picture, without anything before it.
fn wall(light: &str) -> Stage {
    let stage = Stage { light: light.into(), style: two_tones(), ..Stage::default() };
    stage.mesh("wall", "wall.obj", "")
}

fn files(caster: impl Into<Vec<u8>>) -> Files {
    Files::default().with("wall.obj", square(8.0)).with("caster.obj", caster)
}

/// The wall with one model before it, which `more` places.
fn before_wall(light: &str, caster: &str, more: &str) -> Picture {
    wall(light).mesh("caster", "caster.obj", &format!("{more}\n{RED}")).picture_with(files(caster))
}

/// Where the wall shows through a pixel's middle.
fn place((x, y): (u32, u32)) -> Vec2 {
    let px = Vec2::new(x as f32, y as f32) + 0.5 - 0.5 * SIDE as f32;
    Vec2::new(px.x, -px.y) / PX_PER_METRE
}

/// Asserts that the wall is dark just where `expected` says, except a hand's breadth (a pixel) from borders, and
/// that there are at least `least` dark pixels.
#[track_caller]
pub(crate) fn assert_dark(picture: &Picture, least: usize, expected: impl Fn(Vec2) -> bool) {
    let margin = 1.0 / PX_PER_METRE;
    let mut wrong = Vec::new();
    for at in picture.places() {
        let colour = picture.rgb(at.0, at.1);
        assert!([SHADOW, LIT, CASTER].contains(&colour), "{colour:?} at {at:?}");
        let around = [Vec2::X, -Vec2::X, Vec2::Y, -Vec2::Y];
        let dark = expected(place(at));
        let is_clear = around.iter().all(|&side| expected(place(at) + margin * side) == dark);
        if colour != CASTER && is_clear && (colour == SHADOW) != dark {
            wrong.push(at);
        }
    }
    assert!(wrong.is_empty(), "{} pixels are wrong, such as {:?}", wrong.len(), wrong[0]);
    let dark = picture.count(SHADOW);
    assert!(dark >= least, "{dark} pixels are dark, should be {least}");
}

fn in_square(place: Vec2, middle: [f32; 2], half: f32) -> bool {
    (place - Vec2::from(middle)).abs().max_element() < half
}

/// Pixels of a square metre of the wall, less the border of so many metres.
fn pixels(square_metres: f32, border: f32) -> usize {
    (PX_PER_METRE * (PX_PER_METRE * square_metres - border)) as usize
}

#[test]
fn a_plate_throws_its_shadow_where_geometry_says() {
    for turned in ["", "rotation = [0, 180, 0], ", "scale = [-1, 1, 1], "] {
        let transform = format!("transform = {{ {turned}position = [-2.5, 0, 2] }}");
        let picture = before_wall(SUN, &square(1.0), &transform);
        assert_dark(&picture, pixels(4.0, 8.0), |place| in_square(place, [-0.5, 0.0], 1.0));
    }
}

#[test]
fn a_lamp_throws_shadows_that_grow() {
    // Half as far from the lamp as the wall is: twice as wide.
    let lamp = "kind = \"point\", position = [-1, 0.5, 4]";
    let picture = before_wall(lamp, &square(0.5), "transform = { position = [0, 0, 2] }");
    assert_dark(&picture, pixels(2.0, 8.0), |place| in_square(place, [1.0, -0.5], 1.0));
}

#[test]
fn a_lamp_behind_the_camera_and_beside_it_throws_the_same_kind_of_shadow() {
    for lamp in [Vec3::new(0.5, 0.2, 14.0), Vec3::new(6.0, 0.0, 9.0), Vec3::new(3.0, 4.0, 10.0)] {
        let light = format!("kind = \"point\", position = {:?}", lamp.to_array());
        let picture = before_wall(&light, &square(0.5), "transform = { position = [1, 1, 3] }");
        let share = lamp.z / (lamp.z - 3.0);
        let middle = lamp.truncate() + (Vec2::ONE - lamp.truncate()) * share;
        assert_dark(&picture, 100, |place| in_square(place, middle.into(), 0.5 * share));
    }
}

#[test]
fn shadows_of_meshes_are_not_cleaned() {
    let mut stage = wall(SUN);
    stage.style = stage.style.replace("clean = { px = 0 }", "clean = { px = 20 }");
    let transform = format!("transform = {{ position = [-2.5, 0, 2], rotation = [0, 0, 45] }}\n{RED}");
    let picture = stage.mesh("caster", "caster.obj", &transform).picture_with(files(square(0.2)));
    let half = 0.2 * 2_f32.sqrt();
    assert_dark(&picture, 150, |place| (place - Vec2::new(-0.5, 0.0)).abs().element_sum() < half);
}

#[test]
fn three_plates_on_one_edge_throw_a_whole_shadow() {
    // From the edge to the left, to the right, and toward the camera.
    let ends = [[0.0, 0.0], [-1.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let mut obj = String::new();
    for [x, z] in ends {
        write!(obj, "v {x} -1 {z}\nv {x} 1 {z}\n").unwrap();
    }
    // Whichever way round each of them runs.
    for faces in ["f 1 2 4 3\nf 1 2 6 5\nf 1 2 8 7\n", "f 1 2 4 3\nf 2 1 5 6\nf 1 2 8 7\n"] {
        let picture = before_wall(
            "kind = \"sun\", direction = [2, 0, -1]",
            &format!("{obj}{faces}"),
            "transform = { position = [-3, 0, 1] }",
        );
        assert_dark(&picture, pixels(6.0, 10.0), |place| {
            (-2.0..1.0).contains(&place.x) && place.y.abs() < 1.0
        });
    }
}

#[test]
fn a_camera_inside_a_shadow_sees_the_same_shadow() {
    // Behind the camera, which its shadow passes.
    for [x, y] in [[0.0, 0.0], [0.9, -0.4], [1.5, 0.0]] {
        let transform = format!("transform = {{ position = [{x}, {y}, 14] }}");
        let light = "kind = \"sun\", direction = [0.02, 0.01, -1]";
        let picture = before_wall(light, &square(1.0), &transform);
        assert_dark(&picture, pixels(4.0, 8.0), |place| in_square(place, [x + 0.28, y + 0.14], 1.0));
    }
}

#[test]
fn overlapping_shadows_stay_dark() {
    // One behind the other along the light; a count of eight bits would be back at zero.
    let copy = |number: u32| {
        format!("{{ position = [{}, 0, {}] }}", -0.5 - 0.01 * number as f32, 0.01 * number as f32)
    };
    let copies: Vec<_> = (100..356).map(copy).collect();
    let transform = format!("transform = [{}]", copies.join(", "));
    let picture = before_wall(SUN, &square(0.5), &transform);
    assert_dark(&picture, 100, |place| in_square(place, [-0.5, 0.0], 0.5));
}

/// A cube of 1 m with its middle at the origin.
fn cube() -> String {
    let mut obj = String::new();
    for corner in 0..8 {
        let at = [1, 2, 4].map(|bit| if corner & bit == 0 { -0.5 } else { 0.5 });
        writeln!(obj, "v {} {} {}", at[0], at[1], at[2]).unwrap();
    }
    obj + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
}

#[test]
fn a_box_on_a_plane_has_its_shadow_at_its_foot() {
    let picture = before_wall(SUN, &cube(), "transform = { position = [-2, 0, 0.5] }");
    assert_dark(&picture, 500, |place| (-2.5..-0.5).contains(&place.x) && place.y.abs() < 0.5);
    // Right up to the foot, of which the camera sees the box's side.
    let lit = picture.places().filter(|&at| {
        let place = place(at);
        picture.rgb(at.0, at.1) == LIT && (-1.6..-0.55).contains(&place.x) && place.y.abs() < 0.45
    });
    assert_eq!(lit.count(), 0, "light shines under the box");
}

#[test]
fn models_throw_shadows_on_puffs() {
    let direction = Vec3::new(1.0, -0.4, -1.0).normalize_or(Vec3::Y);
    let puff = [0.0, 0.0, -4.0, 9.0];
    let stage = Stage {
        light: format!("kind = \"sun\", direction = {:?}", direction.to_array()),
        style: two_tones(),
        ..Stage::default()
    };
    let stage = stage.balls("puff", &[puff], "style = { shadow = { on = false } }");
    let more = format!("transform = {{ position = [-2, 0.5, 4] }}\n{RED}");
    let picture = stage.mesh("plate", "caster.obj", &more).picture_with(files(square(0.6)));
    let (mut dark, mut wrong) = (0, 0);
    for (x, y) in picture.places() {
        let colour = picture.rgb(x, y);
        let ray = balls::ray(x, y);
        let Some(depth) = balls::distance(ray, puff).filter(|_| colour == SHADOW || colour == LIT) else {
            continue;
        };
        let place = EYE + ray * depth;
        let back = place - direction * ((place.z - 4.0) / direction.z);
        let expected = in_square(back.truncate(), [-2.0, 0.5], 0.6) && place.z < 4.0;
        // The puff's own dark side is dark too.
        let faces = (place - Vec3::new(0.0, 0.0, -4.0)).normalize_or(Vec3::Y).dot(direction) < -0.2;
        dark += usize::from(expected && faces);
        wrong += usize::from(faces && expected != (colour == SHADOW));
    }
    assert!(dark > 1000, "{dark} pixels are dark");
    assert!(wrong * 20 < dark, "{wrong} pixels are wrong of {dark}");
}

#[test]
fn puffs_throw_shadows_on_models() {
    let direction = Vec3::new(1.0, 0.0, -1.0);
    let caster =
        "style = { tones = [\"#ff0000\"], shadow = { on = true, reach = 30, start = 0, size = 0.8 } }";
    let picture = wall(SUN).balls("puff", &[[-2.5, 0.0, 2.0, 1.0]], caster).picture_with(files(""));
    let radius = 0.8 * CORE;
    let area =
        std::f32::consts::PI * radius * radius / -direction.normalize_or(Vec3::Y).z * PX_PER_METRE.powi(2);
    let dark = picture.count(SHADOW) as f32;
    assert!((dark / area - 1.0).abs() < 0.1, "{dark} pixels are dark, should be {area}");
}

#[test]
fn shadows_go_where_their_models_go() {
    let mut bin = Vec::new();
    let corners = [[-0.5, -0.5, 0.0], [0.5, -0.5, 0.0], [0.5, 0.5, 0.0], [-0.5, 0.5, 0.0_f32]];
    let [start, end] = [[-2.5, 0.0, 2.0], [-2.5, 2.0, 2.0_f32]];
    for number in corners.as_flattened().iter().chain(&[0.0, 1.0]).chain(&start).chain(&end) {
        bin.extend(number.to_le_bytes());
    }
    bin.extend([0, 1, 2, 0, 2, 3_u16].iter().flat_map(|corner| corner.to_le_bytes()));
    let view = |offset: u32, length: u32| {
        format!("{{\"buffer\":0,\"byteOffset\":{offset},\"byteLength\":{length}}}")
    };
    let accessor = |view: u32, component: u32, count: u32, kind: &str, bounds: &str| {
        format!(
            "{{\"bufferView\":{view},\"componentType\":{component},\"count\":{count},\"type\":\"{kind}\"{bounds}}}"
        )
    };
    let gltf = format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\
         \"nodes\":[{{\"mesh\":0}}],\
         \"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"indices\":3}}]}}],\
         \"animations\":[{{\"channels\":[{{\"sampler\":0,\"target\":{{\"node\":0,\"path\":\"translation\"}}}}],\
         \"samplers\":[{{\"input\":1,\"output\":2}}]}}],\
         \"buffers\":[{{\"uri\":\"plate.bin\",\"byteLength\":{}}}],\"bufferViews\":[{}],\"accessors\":[{}]}}",
        bin.len(),
        [view(0, 48), view(48, 8), view(56, 24), view(80, 12)].join(","),
        [
            accessor(0, 5126, 4, "VEC3", ",\"min\":[-0.5,-0.5,0],\"max\":[0.5,0.5,0]"),
            accessor(1, 5126, 2, "SCALAR", ",\"min\":[0],\"max\":[1]"),
            accessor(2, 5126, 2, "VEC3", ""),
            accessor(3, 5123, 6, "SCALAR", ""),
        ]
        .join(","),
    );
    let stage = wall(SUN).mesh("plate", "plate.gltf", RED);
    let files = files("").with("plate.gltf", gltf).with("plate.bin", bin);
    let mut engine = engine();
    let mut player = stage.play(&engine, files).unwrap();
    for (frame, y) in [(0, 0.0), (6, 0.5), (12, 1.0)] {
        let picture = picture_at(&mut engine, &mut player, frame).unwrap();
        assert_dark(&picture, pixels(1.0, 4.0), |place| in_square(place, [-0.5, y], 0.5));
    }
}

#[test]
fn who_throws_no_shadow_throws_none_and_who_shows_none_shows_none() {
    let dark = |wall_style: &str, caster: &str| {
        let stage = Stage { light: SUN.into(), style: two_tones(), ..Stage::default() };
        let stage = stage.mesh("wall", "wall.obj", wall_style);
        let plate = format!("transform = {{ position = [-2.5, 0, 2] }}\n{caster}");
        let stage = stage.mesh("caster", "caster.obj", &plate);
        stage.picture_with(files(square(1.0))).count(SHADOW)
    };
    assert!(dark("", RED) > 5000);
    assert_eq!(dark("", "style = { tones = [\"#ff0000\"], shadow = { on = false } }"), 0);
    assert_eq!(dark("", "visible = false"), 0);
    assert_eq!(dark("style = { shadow = { receive = false } }", RED), 0);
}
