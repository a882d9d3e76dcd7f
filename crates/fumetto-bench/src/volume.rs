//! Making a volume's field, and following rays through it.

use std::{
    io,
    time::{Duration, Instant},
};

use anyhow::Context as _;
use fumetto::{Assets, Engine, PICTURE_FORMAT, Player, Shot};

use crate::{
    measure::{Budget, Samples, rounds},
    scene,
    subsystem::Subsystem,
};

pub(crate) const VOLUME: Subsystem = Subsystem {
    name: "volume",
    title: "the field of a cloud of 24 puffs, and pictures of it without antialiasing",
    counted: "cells along the longest side",
    sizes: &[32, 64, 128],
    variants: &[
        "field, 1 octave",
        "field, 6 octaves",
        "field, 6 octaves, light",
        "soft 640x480",
        "soft 1280x720",
        "drawn 1280x720",
    ],
    measure,
};

/// No scene here names a file.
struct NoFiles;

impl Assets for NoFiles {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// What differs between variants.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Case {
    octaves: u32,
    /// Whether it keeps light from itself.
    shadow: bool,
    soft: f32,
    /// The picture's size, where one is drawn; else the field is made anew.
    size: Option<[u32; 2]>,
}

impl Case {
    const FIELD: Self = Self { octaves: 6, shadow: false, soft: 1.0, size: None };

    fn of(variant: &str) -> Option<Self> {
        Some(match variant {
            "field, 1 octave" => Self { octaves: 1, ..Self::FIELD },
            "field, 6 octaves" => Self::FIELD,
            "field, 6 octaves, light" => Self { shadow: true, ..Self::FIELD },
            "soft 640x480" => Self { shadow: true, size: Some([640, 480]), ..Self::FIELD },
            "soft 1280x720" => Self { shadow: true, size: Some([1280, 720]), ..Self::FIELD },
            "drawn 1280x720" => Self { shadow: true, soft: 0.0, size: Some([1280, 720]), ..Self::FIELD },
            _ => return None,
        })
    }

    /// Noise that drifts, so that every frame has another field.
    fn scene(&self, cells: u32) -> String {
        let Self { octaves, shadow, soft, size } = self;
        let [width, height] = size.unwrap_or([16, 16]);
        let puff = |index: u32| {
            let (x, y) = (f64::from(index % 6) * 0.8 - 2.0, f64::from(index / 6) * 0.7 - 1.0);
            format!("{{ center = [{x:.2}, {y:.2}, {:.2}], radius = 0.7 }}", (3.0 * x + 5.0 * y).sin() * 0.4)
        };
        let puffs = (0..24).map(puff).collect::<Vec<_>>().join(", ");
        let light_cells = cells / 2;
        format!(
            r##"
format = 1
[camera]
eye = [0.0, 0.0, 6.0]
target = [0.0, 0.0, 0.0]
[[light]]
kind = "sun"
direction = [0.5, -1.0, -0.6]
[background]
colour = "#6fa8dc"
[output]
size = [{width}, {height}]
antialias = 1
[style]
ink = {{ on = false }}
shadow = {{ on = {shadow} }}
[[object]]
name = "cloud"
kind = "cloud"
particles = [{puffs}]
[object.shape.volume]
soft = {soft:?}
cells = {cells}
light_cells = {light_cells}
noise = {{ amplitude = 0.5, octaves = {octaves}, drift = [0.1, 0.0, 0.0] }}
"##
        )
    }
}

struct Running {
    player: Player,
    frame: u32,
    /// What the picture is drawn into.
    target: Option<wgpu::TextureView>,
}

fn measure(
    engine: &mut Engine,
    variants: &[&'static str],
    size: u32,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let mut cases = variants
        .iter()
        .map(|variant| {
            let case = Case::of(variant).context("there is no such variant")?;
            let scene = scene::load(variant, &case.scene(size))?;
            let mut player = engine.play(scene, Box::new(NoFiles))?;
            engine.seek(&mut player, 0)?;
            engine.gpu().wait()?;
            Ok(Running { player, frame: 0, target: case.size.map(|size| target(engine, size)) })
        })
        .collect::<anyhow::Result<Vec<_>>>()?;
    rounds(&mut cases, budget, |case| time(engine, case))
}

fn time(engine: &mut Engine, case: &mut Running) -> anyhow::Result<Duration> {
    let Running { player, frame, target } = case;
    if let Some(target) = target {
        let shot = Shot::of(player.scene());
        // The first picture of a turn fetches textures that other variants did not need.
        engine.draw(player, &shot, target)?;
        engine.gpu().wait()?;
        let begin = Instant::now();
        engine.draw(player, &shot, target)?;
        engine.gpu().wait()?;
        return Ok(begin.elapsed());
    }
    *frame += 1;
    let begin = Instant::now();
    engine.seek(player, *frame)?;
    engine.gpu().wait()?;
    Ok(begin.elapsed())
}

pub(crate) fn target(engine: &Engine, [width, height]: [u32; 2]) -> wgpu::TextureView {
    let texture = engine.gpu().device.create_texture(&wgpu::TextureDescriptor {
        label: Some("bench.volume.target"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: PICTURE_FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;

    #[test]
    fn every_variant_is_a_good_scene_that_differs_from_the_others() {
        let cases: Vec<_> = VOLUME.variants.iter().map(|variant| Case::of(variant).unwrap()).collect();
        for (index, case) in cases.iter().enumerate() {
            let scene = scene::load("volume", &case.scene(64)).unwrap();
            assert_eq!(scene.objects[0].shape.volume().unwrap().cells, 64);
            assert!(cases[..index].iter().all(|other| other != case));
        }
    }
}
