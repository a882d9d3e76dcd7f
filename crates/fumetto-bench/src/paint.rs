//! Paint: a step in which its volumes spread, and what its reveal adds to a picture.

use std::{
    fmt::Write as _,
    io,
    time::{Duration, Instant},
};

use fumetto::{Assets, Engine, Player};

use crate::{
    draw::{self, Sitter},
    measure::{Budget, Samples, rounds},
    scene,
    subsystem::Subsystem,
};

pub(crate) const SPREAD: Subsystem = Subsystem {
    name: "paint-spread",
    title: "one step of paint that spreads",
    counted: "volumes",
    sizes: &SIZES,
    variants: &["162 vertices", "642 vertices", "2562 vertices"],
    measure: measure_spread,
};

pub(crate) const REVEAL: Subsystem = Subsystem {
    name: "paint-reveal",
    title: "one picture of 1280 x 720 pixels, without antialiasing: a floor that is half painted",
    counted: "volumes",
    sizes: &SIZES,
    variants: &["no paint", "162 vertices", "642 vertices", "2562 vertices"],
    measure: measure_reveal,
};

const SIZES: [u32; 4] = [1, 10, 100, 1000];

/// Volumes are on their way by then.
const WARM_UP_FRAME: u32 = 24;

/// The side of the floor, in metres; all volumes together cover about half of what is seen of it.
const FLOOR_M: f64 = 12.0;

/// Shares of a line that spread points evenly in a plane, as in `cube.rs`.
const SHARES: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3];

/// A floor with a thousand boxes on it, so that there is something to shade and to ink.
#[derive(Clone, Debug)]
struct Floor;

impl Assets for Floor {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        if path == "floor.obj" { Ok(floor().into_bytes()) } else { Err(io::ErrorKind::NotFound.into()) }
    }
}

struct Running {
    player: Player,
    frame: u32,
}

fn measure_spread(
    engine: &mut Engine,
    variants: &[&'static str],
    size: u32,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let mut cases = variants
        .iter()
        .map(|name| {
            let player = engine.play(scene::load(name, &text(pieces(name)?, size))?, Box::new(Floor))?;
            let mut case = Running { player, frame: WARM_UP_FRAME };
            engine.seek(&mut case.player, case.frame)?;
            engine.gpu().wait()?;
            Ok(case)
        })
        .collect::<anyhow::Result<Vec<_>>>()?;
    rounds(&mut cases, budget, |case| next_frame(engine, case))
}

fn next_frame(engine: &Engine, case: &mut Running) -> anyhow::Result<Duration> {
    case.frame += 1;
    let begin = Instant::now();
    engine.seek(&mut case.player, case.frame)?;
    engine.gpu().wait()?;
    Ok(begin.elapsed())
}

fn measure_reveal(
    engine: &mut Engine,
    variants: &[&'static str],
    size: u32,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let cases = variants.iter().map(|variant| {
        let text = text(pieces(variant)?, size);
        Sitter::at(engine, (variant, &text), Box::new(Floor), WARM_UP_FRAME)
    });
    let cases = cases.collect::<anyhow::Result<Vec<_>>>()?;
    draw::time(engine, cases, budget)
}

/// Pieces of an icosahedron's edge that make as many vertices as a variant has.
fn pieces(variant: &str) -> anyhow::Result<Option<u32>> {
    Ok(match variant {
        "no paint" => None,
        "162 vertices" => Some(4),
        "642 vertices" => Some(8),
        "2562 vertices" => Some(16),
        _ => anyhow::bail!("there is no such variant"),
    })
}

fn floor() -> String {
    let half = 0.5 * FLOOR_M;
    let mut obj = format!(
        "v -{half} 0 -{half}\nv -{half} 0 {half}\nv {half} 0 {half}\nv {half} 0 -{half}\nf 1 2 3 4\n"
    );
    for index in 0..1000_u32 {
        let [x, z] = SHARES.map(|share| FLOOR_M * ((share * f64::from(index + 7)).fract() - 0.5));
        for corner in 0..8 {
            let side = |axis: u32| if (corner >> axis) & 1 == 0 { -0.06 } else { 0.06 };
            // Writing to a string cannot fail.
            let _ = writeln!(obj, "v {:.4} {:.4} {:.4}", x + side(0), 0.06 + side(1), z + side(2));
        }
        obj += "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n";
    }
    obj
}

/// A floor and so many volumes on it, whose areas add up to the same whatever their number.
fn text(pieces: Option<u32>, volumes: u32) -> String {
    let mut text = r##"
format = 1
[camera]
eye = [0.0, 7.0, 9.0]
target = [0.0, 0.0, 0.5]
fov = 40
[[light]]
kind = "sun"
direction = [0.5, -1.0, -0.6]
[background]
colour = "#f0e8d8"
[output]
size = [1280, 720]
antialias = 1
[[object]]
name = "floor"
kind = "mesh"
model = "floor.obj"
style = { tones = ["#6a6283", "#e0784a", "#ffd9a0"], shadow = { on = false } }
"##
    .to_owned();
    if let Some(pieces) = pieces {
        let radius = 0.45 * FLOOR_M / f64::from(volumes).sqrt();
        let _ = writeln!(
            text,
            "[[object]]\nname = \"paint\"\nkind = \"paint\"\nspread = {{ subdivisions = {pieces}, grain = 0.15 }}\ndrop = ["
        );
        for index in 0..volumes {
            let [x, z] = SHARES.map(|share| FLOOR_M * ((share * f64::from(index)).fract() - 0.5));
            let _ = writeln!(text, "{{ at = [{x:.4}, 0, {z:.4}], radius = {radius:.4} }},");
        }
        text += "]\n";
    }
    text
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use fumetto_scene::Matter;

    use super::*;

    #[test]
    fn every_variant_is_a_good_scene_with_the_vertices_that_it_names() {
        for variant in REVEAL.variants {
            let scene = scene::load(variant, &text(pieces(variant).unwrap(), 1000)).unwrap();
            let Some(object) = scene.objects.get(1) else {
                assert_eq!(*variant, "no paint");
                continue;
            };
            let Matter::Paint(paint) = &object.matter else { panic!("paint") };
            assert_eq!(paint.volumes(), 1000);
            assert!(variant.starts_with(&paint.spread.vertices().to_string()), "{variant}");
        }
        assert!(pieces("3 vertices").is_err());
    }
}
