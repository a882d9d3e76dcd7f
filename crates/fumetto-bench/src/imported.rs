//! Reading a volume out of a file, the light in it, and following rays through it.

use std::{
    io,
    sync::Arc,
    time::{Duration, Instant},
};

use anyhow::Context as _;
use fumetto::{Assets, Engine, Player, Shot};
use fumetto_formats::{Grid, GridClass, VdbOptions, Voxels, write_vdb};

use crate::{
    measure::{Budget, Samples, rounds},
    scene,
    subsystem::Subsystem,
    volume::target,
};

pub(crate) const IMPORTED: Subsystem = Subsystem {
    name: "imported",
    title: "a lumpy ball out of a VDB file, and pictures of it without antialiasing",
    counted: "voxels along each side",
    sizes: &[64, 128, 256],
    variants: &[
        "load",
        "load, surface 64",
        "load, surface 128",
        "load, light 32",
        "load, light 64",
        "load, light 128",
        "load, light 256",
        "soft 640x480",
        "soft 640x480, steps of 2 voxels",
        "soft 640x480, steps of 4 voxels",
        "soft 640x480, steps of 8 voxels",
        "soft 640x480, steps of 4 voxels, squares of 2 pixels",
        "soft 640x480, steps of 8 voxels, squares of 2 pixels",
        "empty 640x480",
        "soft 1280x720",
        "soft 1280x720, steps of 2 voxels",
        "soft 1280x720, steps of 8 voxels",
        "drawn 1280x720",
    ],
    measure,
};

/// Of the largest lumps.
const FREQUENCY: f32 = 9.0;

/// Of the smallest lumps, over the voxels: half a wave of them is as long as four voxels.
const FINEST: f32 = std::f32::consts::PI / 8.0;

/// How high lumps are over those twice as large.
const PERSISTENCE: f32 = 0.7;

/// The file, whatever it is called.
struct File(Arc<Vec<u8>>);

impl Assets for File {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Ok(self.0.to_vec())
    }
}

/// What differs between variants.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Case {
    /// Cells of light; without any, nothing is in shadow.
    light: u32,
    soft: f32,
    /// Over the default step.
    steps: f32,
    /// Along the side of the square that a ray stands for.
    pixels: u32,
    /// Whether there is anything to see.
    seen: bool,
    /// Cells of an iso-surface in place of what light goes through.
    surface: Option<u32>,
    /// The picture's size, where one is drawn; else the file is read anew.
    size: Option<[u32; 2]>,
}

impl Case {
    const LOAD: Self =
        Self { light: 0, soft: 1.0, steps: 1.0, pixels: 1, seen: true, surface: None, size: None };
    const SOFT: Self = Self { light: 64, size: Some([640, 480]), ..Self::LOAD };

    fn of(variant: &str) -> Option<Self> {
        Some(match variant {
            "load" => Self::LOAD,
            "load, surface 64" => Self { surface: Some(64), ..Self::LOAD },
            "load, surface 128" => Self { surface: Some(128), ..Self::LOAD },
            "load, light 32" => Self { light: 32, ..Self::LOAD },
            "load, light 64" => Self { light: 64, ..Self::LOAD },
            "load, light 128" => Self { light: 128, ..Self::LOAD },
            "load, light 256" => Self { light: 256, ..Self::LOAD },
            "soft 640x480" => Self::SOFT,
            "soft 640x480, steps of 2 voxels" => Self { steps: 4.0, light: 32, ..Self::SOFT },
            "soft 640x480, steps of 4 voxels" => Self { steps: 8.0, light: 32, ..Self::SOFT },
            "soft 640x480, steps of 8 voxels" => Self { steps: 16.0, light: 32, ..Self::SOFT },
            "soft 640x480, steps of 4 voxels, squares of 2 pixels" => {
                Self { steps: 8.0, light: 32, pixels: 2, ..Self::SOFT }
            }
            "soft 640x480, steps of 8 voxels, squares of 2 pixels" => {
                Self { steps: 16.0, light: 32, pixels: 2, ..Self::SOFT }
            }
            "empty 640x480" => Self { seen: false, light: 32, ..Self::SOFT },
            "soft 1280x720" => Self { size: Some([1280, 720]), ..Self::SOFT },
            "soft 1280x720, steps of 2 voxels" => Self { steps: 4.0, size: Some([1280, 720]), ..Self::SOFT },
            "soft 1280x720, steps of 8 voxels" => Self { steps: 16.0, size: Some([1280, 720]), ..Self::SOFT },
            "drawn 1280x720" => Self { soft: 0.0, size: Some([1280, 720]), ..Self::SOFT },
            _ => return None,
        })
    }

    /// A sequence, so that every frame reads a file. The camera and the light are those of
    /// `tools/bench/volumes.py`.
    fn scene(&self, voxels: u32) -> String {
        let Self { light, soft, steps, pixels, seen, surface, size } = self;
        let [width, height] = size.unwrap_or([16, 16]);
        let (shadow, cells) = (*light > 0, (*light).max(4));
        let step = steps / voxels as f32;
        let shape = match surface {
            Some(cells) => format!("surface = {{ threshold = 0.5, subdivisions = {cells} }}"),
            None => format!(
                "volume = {{ soft = {soft:?}, extinction = 6, light_cells = {cells}, step = {step}, pixels = {pixels} }}"
            ),
        };
        format!(
            r##"
format = 1
camera = {{ eye = [0.0, 0.0, 4.0], target = [0.0, 0.0, 0.0], fov = 36 }}
light = [{{ kind = "sun", direction = [0.5, -1.0, -0.6] }}]
background = {{ colour = "#000000" }}
output = {{ size = [{width}, {height}], antialias = 1 }}
style = {{ ink = {{ on = false }}, shadow = {{ on = {shadow} }} }}
[[object]]
name = "ball"
kind = "volume"
visible = {seen}
volume = "ball.#.vdb"
shape = {{ {shape} }}
"##
        )
    }
}

/// The density at a place between -1 and 1, as in `tools/bench/volumes.py`: a ball with lumps on lumps, down to some that
/// are four voxels wide.
fn density([x, y, z]: [f32; 3], voxels: u32) -> f32 {
    let octaves = (voxels as f32 * FINEST / FREQUENCY).log2().floor() as i32;
    let lump = |octave: i32| {
        let frequency = FREQUENCY * 2_f32.powi(octave);
        let wave = |place: f32, shift: f32| (frequency * place + shift).sin();
        PERSISTENCE.powi(octave) * wave(x, 0.0) * wave(y, 1.0) * wave(z, 2.0)
    };
    let lumps: f32 = (0..=octaves).map(lump).sum();
    let radius = (x * x + y * y + z * z).sqrt();
    (12.0 * (0.75 - radius + 0.15 * lumps)).clamp(0.0, 1.0)
}

/// A file of so many voxels along each side of a box from -1 to 1.
fn file(voxels: u32) -> anyhow::Result<Vec<u8>> {
    let place = |index: u32| 2.0 * (index as f32 + 0.5) / voxels as f32 - 1.0;
    let at = |index: u32| {
        let [x, y, z] = [index % voxels, index / voxels % voxels, index / (voxels * voxels)];
        density([x, y, z].map(place), voxels)
    };
    let values: Vec<f32> = (0..voxels.pow(3)).map(at).collect();
    let side = 2.0 / f64::from(voxels);
    let first = 0.5 * side - 1.0;
    let grid = Grid {
        name: "density".to_owned(),
        class: GridClass::FogVolume,
        world_from_index: [
            [side, 0.0, 0.0, 0.0],
            [0.0, side, 0.0, 0.0],
            [0.0, 0.0, side, 0.0],
            [first, first, first, 1.0],
        ],
        voxels: Arc::new(
            Voxels::from_dense([0; 3], [voxels; 3], 1, &values, [0.0; 3])
                .context("there are as many voxels")?,
        ),
    };
    let mut bytes = Vec::new();
    write_vdb(&[grid], VdbOptions { zip: false, half: true }, &mut bytes)?;
    Ok(bytes)
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
    let bytes = Arc::new(file(size)?);
    let mut cases = variants
        .iter()
        .map(|variant| {
            let case = Case::of(variant).context("there is no such variant")?;
            let scene = scene::load(variant, &case.scene(size))?;
            let mut player = engine.play(scene, Box::new(File(Arc::clone(&bytes))))?;
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

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;

    #[test]
    fn every_variant_is_a_good_scene_that_differs_from_the_others() {
        let cases: Vec<_> = IMPORTED.variants.iter().map(|variant| Case::of(variant).unwrap()).collect();
        for (index, case) in cases.iter().enumerate() {
            let scene = scene::load("imported", &case.scene(64)).unwrap();
            assert_eq!(scene.objects[0].shape.surface().is_some(), case.surface.is_some());
            assert!(cases[..index].iter().all(|other| other != case));
        }
    }
}
