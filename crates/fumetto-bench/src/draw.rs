//! Drawing one picture of a still cloud, with and without what can be left out.

use std::time::{Duration, Instant};

use anyhow::Context as _;
use fumetto::{Assets, Engine, PICTURE_FORMAT, Player, Shot};

use crate::{
    cloud::{self, Cloud},
    measure::{Budget, Samples, rounds},
    scene,
    subsystem::Subsystem,
};

pub(crate) const DRAW: Subsystem = Subsystem {
    name: "draw",
    title: "one picture of 1280 x 720 pixels, without antialiasing",
    counted: "puffs",
    sizes: &[1_000, 5_000, 20_000, 100_000],
    variants: &[
        "body",
        "body+ink",
        "body+ink+shadow",
        "body+shadow",
        "body+ink form=0",
        "body+hatching",
        "body+hatching by number",
        "two tones per-pixel",
        "two tones pre-shaded",
        "pre-shaded+ink",
        "pre-shaded+ink+shadow",
    ],
    measure,
};

/// What of a style differs between variants.
#[derive(Clone, Copy, Debug)]
struct Look {
    ink: bool,
    shadow: bool,
    form: f32,
    tones: &'static str,
    shading: &'static str,
    hatching: &'static str,
}

impl Look {
    /// The least: three tones by the form of the whole cloud.
    const BODY: Self = Self {
        ink: false,
        shadow: false,
        form: 0.6,
        tones: r##"["#7f93aa", "#bccad8", "#f2f6f9"]"##,
        shading: "per-pixel",
        hatching: "on = false",
    };
    /// All that can be pre-shaded.
    const TWO_TONES: Self = Self { form: 0.0, tones: r##"["#8c8c8c", "#ffffff"]"##, ..Self::BODY };

    const PRE_SHADED: Self = Self { shading: "pre-shaded", ..Self::TWO_TONES };

    fn of(variant: &str) -> Option<Self> {
        Some(match variant {
            "body" => Self::BODY,
            "body+ink" => Self { ink: true, ..Self::BODY },
            "body+ink+shadow" => Self { ink: true, shadow: true, ..Self::BODY },
            "body+shadow" => Self { shadow: true, ..Self::BODY },
            "body+ink form=0" => Self { ink: true, form: 0.0, ..Self::BODY },
            "body+hatching" => Self { hatching: "layers = 2", ..Self::BODY },
            "body+hatching by number" => Self { hatching: "layers = 3, swell = 0", ..Self::BODY },
            "two tones per-pixel" => Self::TWO_TONES,
            "two tones pre-shaded" => Self::PRE_SHADED,
            "pre-shaded+ink" => Self { ink: true, ..Self::PRE_SHADED },
            "pre-shaded+ink+shadow" => Self { ink: true, shadow: true, ..Self::PRE_SHADED },
            _ => return None,
        })
    }

    fn scene(&self) -> String {
        let Self { ink, shadow, form, tones, shading, hatching } = self;
        let particles = cloud::FILE;
        format!(
            r##"
format = 1
[camera]
eye = [0.0, 1.5, 8.0]
target = [0.0, 1.5, 0.0]
fov = 40
[[light]]
kind = "sun"
direction = [0.5, -1.0, -0.6]
[background]
colour = "#6fa8dc"
[output]
size = [1280, 720]
antialias = 1
[style]
preset = "cartoon"
tones = {tones}
form = {form:?}
shading = "{shading}"
ink = {{ on = {ink}, width = {{ px = 2.0 }} }}
shadow = {{ on = {shadow} }}
hatching = {{ {hatching} }}
[[object]]
name = "plume"
kind = "cloud"
particles = "{particles}"
"##
        )
    }
}

/// A scene that stays as it is while its picture is taken.
pub(crate) struct Sitter {
    player: Player,
    shot: Shot,
}

fn measure(
    engine: &mut Engine,
    variants: &[&'static str],
    size: u32,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let cloud = Cloud::new(size);
    let cases = variants.iter().map(|variant| {
        let look = Look::of(variant).context("there is no such variant")?;
        Sitter::new(engine, variant, &look.scene(), Box::new(cloud.clone()))
    });
    let cases = cases.collect::<anyhow::Result<Vec<_>>>()?;
    time(engine, cases, budget)
}

/// Draws all of them in turn, round by round, at 1280 x 720 pixels.
pub(crate) fn time(
    engine: &mut Engine,
    mut cases: Vec<Sitter>,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let target = target(engine);
    rounds(&mut cases, budget, |case| {
        // The engine frees textures that a few pictures in a row did not need, as those of other variants
        // do not. The first picture of a turn fetches them again and is not timed.
        draw(engine, case, &target)?;
        draw(engine, case, &target)
    })
}

impl Sitter {
    /// The scene that `toml` describes; `name` is what messages call it.
    pub(crate) fn new(
        engine: &Engine,
        name: &str,
        toml: &str,
        assets: Box<dyn Assets>,
    ) -> anyhow::Result<Self> {
        Self::at(engine, (name, toml), assets, 0)
    }

    /// The same at a later frame.
    pub(crate) fn at(
        engine: &Engine,
        (name, toml): (&str, &str),
        assets: Box<dyn Assets>,
        frame: u32,
    ) -> anyhow::Result<Self> {
        let mut player = engine.play(scene::load(name, toml)?, assets).with_context(|| name.to_owned())?;
        engine.seek(&mut player, frame)?;
        let shot = Shot::of(player.scene());
        Ok(Self { player, shot })
    }
}

fn draw(engine: &mut Engine, case: &Sitter, target: &wgpu::TextureView) -> anyhow::Result<Duration> {
    let begin = Instant::now();
    engine.draw(&case.player, &case.shot, target)?;
    engine.gpu().wait()?;
    Ok(begin.elapsed())
}

/// What all variants draw into.
fn target(engine: &Engine) -> wgpu::TextureView {
    let texture = engine.gpu().device.create_texture(&wgpu::TextureDescriptor {
        label: Some("bench.draw.target"),
        size: wgpu::Extent3d { width: 1280, height: 720, depth_or_array_layers: 1 },
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

    use fumetto_scene::{Shading, Width};

    use super::*;

    #[test]
    fn every_variant_is_a_good_scene_that_differs_from_the_others() {
        let scenes: Vec<_> = DRAW
            .variants
            .iter()
            .map(|variant| scene::load(variant, &Look::of(variant).unwrap().scene()).unwrap())
            .collect();
        for (index, scene) in scenes.iter().enumerate() {
            assert_eq!((scene.output.size, scene.output.antialias), ([1280, 720], 1));
            assert_eq!(scene.objects[0].style.ink.width, Width::Px(2.0));
            assert!(scenes[..index].iter().all(|other| other.objects != scene.objects));
        }
    }

    #[test]
    fn what_can_be_pre_shaded_differs_by_that_alone() {
        let style = |variant: &str| {
            let look = Look::of(variant).unwrap();
            scene::load(variant, &look.scene()).unwrap().objects[0].style.clone()
        };
        let pre_shaded = style("two tones pre-shaded");
        assert_eq!(pre_shaded.shading, Shading::PreShaded);
        let mut per_pixel = style("two tones per-pixel");
        per_pixel.shading = Shading::PreShaded;
        assert_eq!(per_pixel, pre_shaded);
    }
}
