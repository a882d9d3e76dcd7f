//! Lines along the edges and contours of a model.

use std::time::{Duration, Instant};

use anyhow::Context as _;
use fumetto::{Engine, PICTURE_FORMAT, Player, Shot};

use crate::{
    boulder::Boulder,
    measure::{Budget, Samples, rounds},
    scene,
    subsystem::Subsystem,
};

pub(crate) const EDGES: Subsystem = Subsystem {
    name: "edges",
    title: "one picture of a model",
    counted: "triangles",
    sizes: &[5_000, 50_000, 500_000],
    variants: &[
        "find: none",
        "find: smooth",
        "find: flat",
        "find: strokes",
        "draw: none",
        "draw: smooth",
        "draw: flat",
        "draw: strokes",
        "draw: dashed",
        "draw: hybrid",
        "draw: image",
        "draw: shell",
        "draw: angle",
    ],
    measure,
};

/// What differs between variants.
#[derive(Clone, Copy, Debug)]
struct Look {
    /// A picture of few pixels takes as long as finding lines does.
    size: [u32; 2],
    /// Angle up to which faces blend.
    smooth_deg: u32,
    ink: &'static str,
}

impl Look {
    fn of(variant: &str) -> Option<Self> {
        let (stage, kind) = variant.split_once(": ")?;
        let size = match stage {
            "find" => [16, 9],
            "draw" => [1280, 720],
            _ => return None,
        };
        let (smooth_deg, ink) = match kind {
            "none" => (180, "on = false"),
            "smooth" => (180, "method = \"vector\""),
            "flat" => (0, "method = \"vector\""),
            "strokes" => (180, "method = \"vector\", stroke = { texture = \"brush\" }"),
            "dashed" => (180, "method = \"vector\", hidden = \"dashed\""),
            "hybrid" => (180, "method = \"hybrid\""),
            "image" => (180, "method = \"image\""),
            "shell" => (180, "method = \"shell\""),
            "angle" => (180, "method = \"angle\""),
            _ => return None,
        };
        Some(Self { size, smooth_deg, ink })
    }

    fn scene(&self) -> String {
        let Self { size: [width, height], smooth_deg, ink } = self;
        format!(
            r##"
format = 1
[camera]
eye = [0.0, 1.5, 5.0]
target = [0.0, 0.0, 0.0]
fov = 40
[output]
size = [{width}, {height}]
antialias = 1
[style]
clean = {{ px = 0 }}
ink = {{ width = {{ px = 2.0 }}, {ink} }}
shadow = {{ on = false }}
[[object]]
name = "boulder"
kind = "mesh"
model = "boulder.obj"
smooth = {smooth_deg}
"##
        )
    }
}

struct Sitter {
    player: Player,
    shot: Shot,
    target: wgpu::TextureView,
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
    rounds(&mut cases, budget, |case| {
        // The first picture fetches textures that other variants had no use for.
        draw(engine, case)?;
        draw(engine, case)
    })
}

fn sit(engine: &Engine, variant: &str, boulder: &Boulder) -> anyhow::Result<Sitter> {
    let look = Look::of(variant).context("there is no such variant")?;
    let mut player = engine.play(scene::load(variant, &look.scene())?, Box::new(boulder.clone()))?;
    engine.seek(&mut player, 0)?;
    let shot = Shot::of(player.scene());
    let [width, height] = shot.size;
    let texture = engine.gpu().device.create_texture(&wgpu::TextureDescriptor {
        label: Some("bench.edges.target"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: PICTURE_FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    let target = texture.create_view(&wgpu::TextureViewDescriptor::default());
    Ok(Sitter { player, shot, target })
}

fn draw(engine: &mut Engine, case: &Sitter) -> anyhow::Result<Duration> {
    let begin = Instant::now();
    engine.draw(&case.player, &case.shot, &case.target)?;
    engine.gpu().wait()?;
    Ok(begin.elapsed())
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;

    #[test]
    fn every_variant_is_a_good_scene_that_differs_from_the_others() {
        let texts: Vec<_> = EDGES.variants.iter().map(|variant| Look::of(variant).unwrap().scene()).collect();
        for (index, text) in texts.iter().enumerate() {
            assert_eq!(scene::load("edges", text).unwrap().objects.len(), 1);
            assert!(!texts[..index].contains(text));
        }
    }
}
