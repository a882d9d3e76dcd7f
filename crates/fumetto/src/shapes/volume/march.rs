//! Rays through volumes, for one picture.
//!
//! Where one ray stands for a square of pixels, rays are followed into layers of their own, as coarse as that, and from
//! there brought to the pixels.

use super::{
    field::{Field, view},
    scene::{Made, VolumeScene},
};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, linear_sampler, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct March {
    march: RenderPipeline,
    march_bricks: RenderPipeline,
    spread: RenderPipeline,
    place: RenderPipeline,
    linear: wgpu::Sampler,
}

impl March {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let build = |program, pipeline: RasterPipeline<'_>| pipeline.build(&gpu.module(program));
        let targets = &[layers::HITS_FORMAT, layers::LIGHT_FORMAT, layers::SOFT_FORMAT];
        let march = |label| RasterPipeline { label, targets, ..Default::default() };
        let place = RasterPipeline {
            label: "shapes.volume.place",
            targets: &[layers::ID_FORMAT],
            depth: Some(layers::nearest_wins()),
            ..Default::default()
        };
        Self {
            march: build(shader!("shapes/volume/march"), march("shapes.volume.march")),
            march_bricks: build(shader!("shapes/volume/bricks/march"), march("shapes.volume.bricks.march")),
            spread: build(shader!("shapes/volume/spread"), march("shapes.volume.spread")),
            place: build(shader!("shapes/volume/place"), place),
            linear: linear_sampler(gpu),
        }
    }

    /// Follows rays through the volumes of the objects that `members` numbers, one after the other, up to what the
    /// layers hold; and brings the surfaces that they meet into the layers.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (scene, members): (&VolumeScene, &[usize]),
        layers: &mut Layers,
    ) {
        for (number, volume) in scene.of(members).enumerate() {
            if number == 0 {
                layers.add_volumes(frame);
            }
            let recipe = frame.uniform("shapes.volume.recipe", &volume.recipe.uniform(0.0));
            let is_first = number == 0;
            match volume.recipe.volume.pixels {
                1 => {
                    let target = Filled::of(layers).target(is_first);
                    self.march(frame, subject, (volume, &recipe), layers, target);
                }
                pixels => {
                    let coarse = Coarse::new(frame, layers.size, pixels);
                    self.march(frame, subject, (volume, &recipe), layers, coarse.filled().target(true));
                    self.spread(frame, subject, (&coarse, &recipe), layers, is_first);
                }
            }
            frame.fullscreen(
                "shapes.volume.place",
                &self.place,
                layers.target(),
                &[wgpu::BindingResource::TextureView(&layers.hits)],
            );
        }
    }

    fn march(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (volume, recipe): (&Made, &wgpu::Buffer),
        layers: &Layers,
        target: Target<'_>,
    ) {
        let (label, pipeline, [grid, spaces], [density, transmitted]) = match &volume.field {
            Field::Cells(field) => {
                let textures = [&field.density, &field.transmitted].map(view);
                ("shapes.volume.march", &self.march, [&field.grid, &field.occupied], textures)
            }
            Field::Bricks(field) => {
                let textures = [&field.atlas, &field.transmitted].map(view);
                ("shapes.volume.bricks.march", &self.march_bricks, [&field.grid, &field.table], textures)
            }
        };
        let mut bindings = vec![
            subject.view.as_entire_binding(),
            recipe.as_entire_binding(),
            wgpu::BindingResource::Sampler(&self.linear),
            grid.as_entire_binding(),
            spaces.as_entire_binding(),
            wgpu::BindingResource::TextureView(&density),
            subject.lights.as_entire_binding(),
            wgpu::BindingResource::TextureView(&transmitted),
            wgpu::BindingResource::TextureView(&layers.depth),
        ];
        let owners = volume.field.owners().map(view);
        bindings.extend(owners.as_ref().map(wgpu::BindingResource::TextureView));
        frame.fullscreen(label, pipeline, target, &bindings);
    }

    /// Brings to each pixel what was found for squares of them.
    fn spread(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (coarse, recipe): (&Coarse, &wgpu::Buffer),
        layers: &Layers,
        is_first: bool,
    ) {
        let bindings = [
            subject.view.as_entire_binding(),
            recipe.as_entire_binding(),
            wgpu::BindingResource::TextureView(&layers.depth),
            wgpu::BindingResource::TextureView(&coarse.hits),
            wgpu::BindingResource::TextureView(&coarse.light),
            wgpu::BindingResource::TextureView(&coarse.soft),
        ];
        let target = Filled::of(layers).target(is_first);
        frame.fullscreen("shapes.volume.spread", &self.spread, target, &bindings);
    }
}

/// Where one ray stands for a square of pixels: what layers have of volumes, of a texel to a square.
#[derive(Debug)]
struct Coarse {
    hits: Transient,
    light: Transient,
    soft: Transient,
}

impl Coarse {
    fn new(frame: &Frame<'_>, size: [u32; 2], pixels: u32) -> Self {
        // Squares begin where the picture does, which may be in the middle of one here; and there is one more all round
        // (`squares.wgsl`).
        let size = size.map(|side| side.div_ceil(pixels) + 3);
        Self {
            hits: frame.texture("shapes.volume.hits", size, layers::HITS_FORMAT),
            light: frame.texture("shapes.volume.light", size, layers::LIGHT_FORMAT),
            soft: frame.texture("shapes.volume.soft", size, layers::SOFT_FORMAT),
        }
    }

    fn filled(&self) -> Filled<'_> {
        Filled([&self.hits, &self.light, &self.soft])
    }
}

/// The layers that rays fill: hits, light and soft.
#[derive(Debug)]
struct Filled<'a>([&'a Transient; 3]);

impl<'a> Filled<'a> {
    fn of(layers: &'a Layers) -> Self {
        Self([&layers.hits, &layers.light, &layers.soft])
    }

    /// Emptied before, or as they are.
    fn target(self, empty: bool) -> Target<'a> {
        let clear = empty.then_some(wgpu::Color::TRANSPARENT);
        Target { colours: self.0.into_iter().map(|layer| (&**layer, clear)).collect(), depth: None }
    }
}
