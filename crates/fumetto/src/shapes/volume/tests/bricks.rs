//! Volumes out of files, against the closed forms and the file's own numbers.

use std::{
    io,
    sync::{Arc, PoisonError},
};

use fumetto_formats::{Grid, GridClass, VdbOptions, Voxels, write_vdb};
use fumetto_scene::{Scene, SceneText};
use glam::{DMat4, DVec3};

use super::{AWAY, BENCH, SIDE, Soft, marched};
use crate::{Assets, Error, Player};

/// One file, whatever it is called.
struct File(Vec<u8>);

impl Assets for File {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Ok(self.0.clone())
    }
}

/// Voxels of a box `[0, size)³` by their index.
fn voxels(size: u32, value: impl Fn(DVec3) -> f64) -> Voxels {
    let side = 0..size;
    let at = side.clone().flat_map(|z| {
        let side = side.clone();
        side.clone().flat_map(move |y| side.clone().map(move |x| DVec3::new(x.into(), y.into(), z.into())))
    });
    let values: Vec<f32> = at.map(|index| value(index) as f32).collect();
    Voxels::from_dense([0; 3], [size; 3], 1, &values, [0.0; 3]).expect("as many values as voxels")
}

fn grid(name: &str, voxels: Voxels, world_from_index: DMat4) -> Grid {
    let (class, world_from_index) = (GridClass::FogVolume, world_from_index.to_cols_array_2d());
    Grid { name: name.into(), class, world_from_index, voxels: Arc::new(voxels) }
}

fn vdb(grids: &[Grid]) -> File {
    let mut bytes = Vec::new();
    write_vdb(grids, VdbOptions { zip: true, half: false }, &mut bytes).expect("it fits into memory");
    File(bytes)
}

/// Seen along -z as the puffs of the other tests are.
fn play(file: File, read: &str, object: &str, volume: &str) -> Result<Player, Error> {
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let toml = format!(
        "format = 1\ncamera = {{ eye = [0, 0, {AWAY}], target = [0, 0, 0], fov = 53.130102, near = 0.01 }}\n\
         light = [{{ kind = \"sun\", direction = [0, -1, 0] }}]\n[[object]]\nname = \"file\"\nkind = \"volume\"\n\
         volume = {{ file = \"a.vdb\", {read} }}\n{object}\nshape = {{ volume = {{ soft = 1, {volume} }} }}"
    );
    let text = SceneText { name: "test", toml: &toml, ..Default::default() };
    let (scene, _) = Scene::load(&text, &mut |_| Err("there are no styles".into()))
        .unwrap_or_else(|report| panic!("{}", report.render(false)));
    let mut player = bench.engine.play(scene, Box::new(file))?;
    bench.engine.seek(&mut player, 0)?;
    Ok(player)
}

fn seen(file: File, read: &str, object: &str, volume: &str) -> Soft {
    let player = play(file, read, object, volume).expect("the file can be drawn");
    marched(&BENCH.lock().unwrap_or_else(PoisonError::into_inner), &player)
}

fn opacity(soft: &Soft, x: u32, y: u32) -> f32 {
    soft[(y * SIDE + x) as usize][3]
}

/// Of a place in the plane z = 0.
fn pixel(metres: f32) -> u32 {
    ((metres / AWAY + 0.5) * SIDE as f32) as u32
}

/// A box of density 1 whose faces lie at half voxels, 1 m wide around the origin.
fn block(voxel_m: f64) -> File {
    let count = (1.0 / voxel_m).round() as u32;
    let first = DVec3::splat(-0.5 + 0.5 * voxel_m);
    let world_from_index = DMat4::from_translation(first) * DMat4::from_scale(DVec3::splat(voxel_m));
    vdb(&[grid("density", voxels(count, |_| 1.0), world_from_index)])
}

#[test]
fn samples_sit_where_the_file_says() {
    for voxel_m in [0.25, 0.0625, 0.03125] {
        let soft = seen(block(voxel_m), "", "", "extinction = 2, step = 0.005");
        let middle = opacity(&soft, SIDE / 2, SIDE / 2);
        // Between the outermost voxels and those beyond, density falls to nothing: half a voxel stands out, but
        // as much as that lacks inside.
        assert!((middle - (1.0 - (-2.0_f32).exp())).abs() < 4e-3, "{middle} with voxels of {voxel_m} m");
        let sum: f32 = soft.iter().map(|texel| texel[0].max(texel[3])).sum();
        let mirrored =
            |x: u32, y: u32| (opacity(&soft, x, y) - opacity(&soft, SIDE - 1 - x, SIDE - 1 - y)).abs();
        let uneven = (0..SIDE * SIDE).map(|index| mirrored(index % SIDE, index / SIDE)).fold(0.0, f32::max);
        assert!(uneven < 0.05 && sum > 100.0, "{uneven}: the box is around the origin");
    }
}

#[test]
fn what_lies_between_voxels_is_linear_across_bricks() {
    // Density grows along x over five bricks, and is the same along z.
    let ramp = grid("density", voxels(40, |index| index.x / 39.0), DMat4::IDENTITY);
    let object = "transform = { scale = 0.05, position = [-0.975, -0.975, -0.975] }";
    let soft = seen(vdb(&[ramp]), "", object, "extinction = 0.5, step = 0.01");
    let deep = 40.0 * 0.05;
    for x in pixel(-0.7)..pixel(0.7) {
        // Seen from so near, a ray goes through a little of the densities beside it.
        let metres = ((x as f32 + 0.5) / SIDE as f32 - 0.5) * AWAY;
        let expected = 1.0 - (-0.5 * deep * (metres + 0.975) / 1.95).exp();
        let found = opacity(&soft, x, SIDE / 2);
        assert!((found - expected).abs() < 0.02, "{found} at {metres} m, should be {expected}");
    }
}

#[test]
fn files_whose_z_points_up_are_turned_and_moved() {
    let high = grid("density", voxels(8, |_| 1.0), DMat4::from_translation(DVec3::new(0.0, 0.0, 8.0)));
    let object = "up = \"z\"\ntransform = { scale = 0.1, position = [-0.35, 0, 0.35] }";
    let soft = seen(vdb(&[high]), "", object, "extinction = 50");
    assert!(opacity(&soft, SIDE / 2, SIDE - 1 - pixel(1.15)) > 0.9, "it stands above");
    assert!(opacity(&soft, SIDE / 2, SIDE - 1 - pixel(-0.2)) < 0.01);
}

#[test]
fn three_voxels_in_a_box_of_a_trillion_take_little() {
    let far = 9_999;
    let mut all = Voxels::from_dense([0; 3], [1; 3], 1, &[1.0], [0.0; 3]).expect("one voxel");
    for place in [[far / 2; 3], [far; 3]] {
        let one = Voxels::from_dense(place, [1; 3], 1, &[1.0], [0.0; 3]).expect("one voxel");
        all.bricks.extend(one.bricks);
        all.values.extend(one.values);
    }
    // Of 20 cm, with the middle one at the origin, and the camera in the box.
    let middle = DMat4::from_translation(DVec3::splat(-0.2 * f64::from(far / 2)));
    let file = vdb(&[grid("density", all, middle * DMat4::from_scale(DVec3::splat(0.2)))]);
    let imported = |file: &File| {
        let player = play(File(file.0.clone()), "", "", "extinction = 1e6").expect("it is small");
        let fumetto_scene::Matter::Imported(imported) = &player.scene().objects[0].matter else {
            panic!("it is out of a file")
        };
        crate::imported_size(file, imported, 0).expect("it is small")
    };
    let size = imported(&file);
    assert_eq!(size.voxels, 3);
    assert!(size.bricks <= 24 && size.bytes < 4 << 20, "{size:?}");
    let soft = seen(file, "", "", "extinction = 100");
    assert!(opacity(&soft, SIDE / 2, SIDE / 2) > 0.9, "the camera sees the one before it");
    let others = soft.iter().filter(|texel| texel[3] > 0.0).count();
    assert!(others < 100, "{others} pixels are not empty");
}

#[test]
fn a_row_of_a_million_voxels_is_seen_along_it_and_a_wider_one_is_refused() {
    let row = |length: i32| {
        let mut all = Voxels::from_dense([0; 3], [1; 3], 1, &[1.0], [0.0; 3]).expect("one voxel");
        for x in [length / 2, length] {
            let one = Voxels::from_dense([x, 0, 0], [1; 3], 1, &[1.0], [0.0; 3]).expect("one voxel");
            all.bricks.extend(one.bricks);
            all.values.extend(one.values);
        }
        // Of 20 cm and along the camera's way, the one in the middle at the origin.
        let along =
            DMat4::from_rotation_y(std::f64::consts::FRAC_PI_2) * DMat4::from_scale(DVec3::splat(0.2));
        let middle = DMat4::from_translation(DVec3::new(f64::from(-length / 2), 0.0, 0.0));
        vdb(&[grid("density", all, along * middle)])
    };
    // However short steps are asked for, they come to an end.
    for step in ["extinction = 100", "extinction = 100, step = 1e-6"] {
        let soft = seen(row(1_000_000), "", "", step);
        assert!(opacity(&soft, SIDE / 2, SIDE / 2) > 0.9, "the camera sees the one before it with {step}");
    }
    let error = play(row(2_000_000), "", "", "").map(drop).expect_err("it is too wide").to_string();
    assert!(error.contains("2000256 x 256 x 256 voxels, where"), "{error}");
}

#[test]
fn heat_colours_matter_and_makes_it_glow() {
    let density = grid("smoke", voxels(16, |_| 1.0), DMat4::IDENTITY);
    let heat = grid("flame", voxels(16, |index| if index.x > 7.5 { 3.0 } else { 1.0 }), DMat4::IDENTITY);
    let read = "density = \"smoke\", heat = \"flame\", heat_range = [1, 3]";
    let object = "transform = { scale = 0.1, position = [-0.75, -0.75, -0.75] }\nstyle.shadow.on = false";
    let volume = "extinction = 100, glow = 2, colours = [[1, 0, 0], [0, 1, 0]]";
    let soft = seen(vdb(&[density, heat]), read, object, volume);
    let at = |metres: f32| soft[(SIDE / 2 * SIDE + pixel(metres)) as usize];
    let [cold, hot] = [at(-0.5), at(0.5)];
    // The sun gives 1 everywhere, for nothing is in shadow.
    assert!((cold[0] - 1.0).abs() < 0.02 && cold[1] < 0.02, "{cold:?}");
    assert!((hot[1] - 3.0).abs() < 0.05 && hot[0] < 0.02, "{hot:?}");
}

#[test]
fn light_dies_in_bricks_as_in_the_closed_form() {
    // Seen from the front, a box lit from above: light falls by exp(-extinction * depth).
    let soft = seen(block(0.0625), "", "", "extinction = 3, light_cells = 64, colours = [[1, 1, 1]]");
    for metres in [0.3, 0.0, -0.3_f32] {
        let line = SIDE - 1 - pixel(metres);
        let texel = soft[(line * SIDE + SIDE / 2) as usize];
        let metres = (0.5 - (line as f32 + 0.5) / SIDE as f32) * AWAY;
        let expected = (-3.0 * (0.5 - metres)).exp();
        let found = texel[0] / texel[3];
        // More light comes to the rim, which is half as dense, and to what a ray that falls sees first.
        assert!((found / expected - 1.0).abs() < 0.3, "{found} at {metres} m, should be {expected}");
    }
}

#[test]
fn what_cannot_be_drawn_is_told() {
    let error = |file: File, read: &str| {
        play(file, read, "", "").map(drop).expect_err("it cannot be drawn").to_string()
    };
    let one = || voxels(8, |_| 1.0);
    let names = error(vdb(&[grid("heat", one(), DMat4::IDENTITY)]), "density = \"heat\", heat = \"flame\"");
    assert_eq!(
        names,
        "a.vdb: there is no grid of single numbers called \"flame\" in it, but \"heat\"; name one of these in the \
         scene"
    );
    let outside = error(vdb(&[grid("density", one(), DMat4::IDENTITY)]), "range = [-1, 1]");
    assert!(outside.contains("its voxels are 0 wherever nothing is stored"), "{outside}");
    let mut wide = one();
    wide.bricks[0].origin = [-2_000_000_000, 0, 0];
    let far = one();
    wide.bricks.extend(far.bricks);
    wide.values.extend(far.values);
    let bricks = |z: i32| {
        let mut own = one();
        own.bricks[0].origin = [0, 2_000_000_000, z];
        own
    };
    for more in [bricks(0), bricks(2_000_000_000)] {
        wide.bricks.extend(more.bricks);
        wide.values.extend(more.values);
    }
    let wide = error(vdb(&[grid("density", wide, DMat4::IDENTITY)]), "");
    assert!(wide.contains("lies in a box of") && wide.contains("bytes"), "{wide}");
}
