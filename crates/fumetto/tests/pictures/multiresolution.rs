//! Surfaces whose cells are lengths on the picture.

use fumetto::{Engine, Player, Shot};

use crate::stage::{BACKGROUND, Files, Picture, SIDE, Stage, engine};

/// Lobes that hide each other, with noise on them.
const LOBES: [[f32; 4]; 5] = [
    [0.0, 0.0, 2.0, 2.0],
    [1.4, 0.6, 0.0, 2.2],
    [-1.6, 0.4, -1.0, 2.0],
    [0.2, -1.2, 0.5, 1.6],
    [0.3, 1.6, -2.0, 2.4],
];

fn cloud(shape: &str) -> Stage {
    let shape = format!("{shape}, noise = {{ amplitude = 1, size = 0.9 }}");
    Stage::default().surface("cloud", &LOBES, &shape, "")
}

fn shot_from(player: &Player, z: f32) -> Shot {
    let mut shot = Shot::of(player.scene());
    shot.camera.eye[2] = z;
    shot
}

fn picture_from(engine: &mut Engine, player: &Player, z: f32) -> Picture {
    Picture(engine.picture(player, &shot_from(player, z)).unwrap())
}

/// Pixels that one shows and the other does not.
fn changed(a: &Picture, b: &Picture) -> usize {
    a.places().filter(|&(x, y)| (a.rgb(x, y) == BACKGROUND) != (b.rgb(x, y) == BACKGROUND)).count()
}

/// Pixels within two of the mask's border.
fn border(mask: &Picture) -> usize {
    let inside = |x: u32, y: u32| mask.rgb(x, y) != BACKGROUND;
    let is_near = |&(x, y): &(u32, u32)| {
        let around = || (y - 2..=y + 2).flat_map(|y| (x - 2..=x + 2).map(move |x| (x, y)));
        around().any(|(x, y)| inside(x, y)) && !around().all(|(x, y)| inside(x, y))
    };
    mask.places().filter(|&(x, y)| x.min(y) > 1 && x.max(y) < SIDE - 2).filter(is_near).count()
}

#[test]
fn measure() {
    let mut engine = engine();
    for px in [2.0_f32, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0] {
        let mut drawn = |px: f32, z: f32| {
            let mut player = cloud(&format!("pixels = {px}")).play(&engine, Files::default()).unwrap();
            engine.seek(&mut player, 0).unwrap();
            picture_from(&mut engine, &player, z)
        };
        let steps: Vec<_> = [10.0, 14.0]
            .iter()
            .map(|&z| {
                let [fine, coarse] = [drawn(px, z), drawn(1.19 * px, z)];
                let moved = drawn(px, 0.999 * z);
                (changed(&fine, &coarse), changed(&fine, &moved), border(&fine))
            })
            .collect();
        eprintln!("{px}: {steps:?}");
    }
}
