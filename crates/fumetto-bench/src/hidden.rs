//! Lines of a model as vector graphics, with what is hidden left out.

use std::time::Instant;

use anyhow::Context as _;
use fumetto::{Engine, LineModel, Shot};

use crate::{
    boulder::Boulder,
    measure::{Budget, Samples, rounds},
    scene,
    subsystem::Subsystem,
};

pub(crate) const HIDDEN: Subsystem = Subsystem {
    name: "hidden",
    title: "all lines of a model as curves without what is hidden",
    counted: "triangles",
    sizes: &[5_000, 50_000, 500_000],
    variants: &["smooth", "flat"],
    measure,
};

fn scene_of(variant: &str) -> Option<String> {
    let smooth_deg = match variant {
        "smooth" => 180,
        "flat" => 0,
        _ => return None,
    };
    Some(format!(
        r##"
format = 1
[camera]
eye = [0.0, 1.5, 5.0]
target = [0.0, 0.0, 0.0]
fov = 40
[output]
size = [1280, 720]
[style]
ink = {{ width = {{ px = 2.0 }}, method = "vector" }}
[[object]]
name = "boulder"
kind = "mesh"
model = "boulder.obj"
smooth = {smooth_deg}
"##
    ))
}

fn measure(
    engine: &mut Engine,
    variants: &[&'static str],
    size: u32,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let boulder = Boulder::new(size);
    let mut cases = variants
        .iter()
        .map(|variant| sit(engine, variant, &boulder).with_context(|| (*variant).to_owned()))
        .collect::<anyhow::Result<Vec<_>>>()?;
    rounds(&mut cases, budget, |(model, shot)| {
        let begin = Instant::now();
        let shapes = model.shapes(shot, false);
        let taken = begin.elapsed();
        anyhow::ensure!(!shapes.is_empty(), "a boulder has lines");
        Ok(taken)
    })
}

fn sit(engine: &Engine, variant: &str, boulder: &Boulder) -> anyhow::Result<(LineModel, Shot)> {
    let text = scene_of(variant).context("there is no such variant")?;
    let mut player = engine.play(scene::load(variant, &text)?, Box::new(boulder.clone()))?;
    engine.seek(&mut player, 0)?;
    Ok((engine.line_model(&player)?, Shot::of(player.scene())))
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;

    #[test]
    fn every_variant_is_a_good_scene() {
        for variant in HIDDEN.variants {
            assert_eq!(scene::load("hidden", &scene_of(variant).unwrap()).unwrap().objects.len(), 1);
        }
    }
}
