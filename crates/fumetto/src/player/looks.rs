//! How objects look: as they are, and as paint shows them.

use std::collections::BTreeMap;

use fumetto_formats::Image;
use fumetto_scene::{Background, Ink, InkMethod, Matter, Object, Ramp, RampImage, Scene, Style};

use crate::{
    Assets, Error,
    assets::load_image,
    details::Details,
    gpu::Gpu,
    ink::StrokeTextures,
    tone::{Backdrop, Ramps},
};

/// One way of drawing all objects.
pub(crate) struct Look {
    /// The scene's objects without their particles, then the layers of detail in them.
    objects: Vec<Object>,
    pub(crate) ramps: Ramps,
}

impl Look {
    /// The scene's own look, and those of its paints in the order of [`Scene::styled_looks`].
    pub(super) fn all(
        gpu: &Gpu,
        scene: &Scene,
        details: &Details,
        assets: &dyn Assets,
    ) -> Result<Vec<Self>, Error> {
        // Objects often share a ramp image; each file is read once.
        let mut images = BTreeMap::new();
        let own: Vec<Style> = scene.objects.iter().map(|object| object.style.clone()).collect();
        let looks = std::iter::once(&own[..]).chain(scene.styled_looks());
        looks.map(|styles| Self::new(gpu, scene, (details, styles), assets, &mut images)).collect()
    }

    fn new(
        gpu: &Gpu,
        scene: &Scene,
        (details, styles): (&Details, &[Style]),
        assets: &dyn Assets,
        images: &mut BTreeMap<String, Image>,
    ) -> Result<Self, Error> {
        let mut objects: Vec<Object> =
            scene.objects.iter().zip(styles).map(|(object, style)| husk(object, style)).collect();
        for object in &objects {
            if let Ramp::Image(RampImage { path, .. }) = &object.style.ramp
                && !images.contains_key(path)
            {
                images.insert(path.clone(), load_image(assets, path)?);
            }
        }
        let ramps = Ramps::new(gpu, &objects, images);
        for (layer, object) in details.layers().iter().zip(details.objects()) {
            let mut object = object.clone();
            // Where a look has no lines there are none inside either.
            object.style.ink.on &= styles[layer.object].ink.on;
            objects.push(object);
        }
        Ok(Self { objects, ramps })
    }

    /// The scene's objects, then the layers of detail in them.
    pub(crate) fn drawn(&self) -> &[Object] {
        &self.objects
    }
}

/// `object` in a style, without the particles that a cloud may have a million of.
fn husk(object: &Object, style: &Style) -> Object {
    let matter = match &object.matter {
        Matter::Still(_) | Matter::Morph(_) => Matter::Still(Vec::new()),
        matter @ (Matter::File(_)
        | Matter::Smoke(_)
        | Matter::Mesh(_)
        | Matter::Imported(_)
        | Matter::Paint(_)) => matter.clone(),
    };
    Object {
        name: object.name.clone(),
        visible: object.visible,
        matter,
        shape: object.shape.clone(),
        details: object.details.clone(),
        style: style.clone(),
        opacity: object.opacity,
    }
}

pub(super) fn load_backdrop(gpu: &Gpu, scene: &Scene, assets: &dyn Assets) -> Result<Backdrop, Error> {
    let image = match &scene.background {
        Background::Image(path) => Some(load_image(assets, path)?),
        _ => None,
    };
    Ok(Backdrop::new(gpu, &scene.background, image.as_ref()))
}

/// Whether any lines are drawn as strokes, in any look.
pub(super) fn has_strokes(scene: &Scene) -> bool {
    scene.inks().any(Ink::has_strokes)
}

pub(super) fn load_strokes(gpu: &Gpu, scene: &Scene, assets: &dyn Assets) -> Result<StrokeTextures, Error> {
    let load = |path: &str| Ok((path.to_owned(), load_image(assets, path)?));
    let images = scene.stroke_pictures().into_iter().map(load).collect::<Result<_, Error>>()?;
    Ok(StrokeTextures::new(gpu, &images))
}

/// For each object the angle from which on edges are creases, where it wants lines along them in any look: that of the
/// first such look, for edges are found once for all.
pub(super) fn crease_degs(scene: &Scene) -> Vec<Option<f32>> {
    let wanted = |ink: &Ink| ink.on && matches!(ink.method, InkMethod::Vector | InkMethod::Hybrid);
    let angle = |object| {
        let inks = scene.styles_of(object).map(|style| &style.ink);
        inks.filter(|ink| wanted(ink)).map(|ink| ink.crease_deg).next()
    };
    (0..scene.objects.len()).map(angle).collect()
}

/// Whether an object wants an outline by a larger copy, in any look.
pub(super) fn wants_shell(scene: &Scene, object: usize) -> bool {
    scene.styles_of(object).any(|style| style.ink.method == InkMethod::Shell)
}

/// How many scales of relief are exaggerated of an object, in any look.
pub(super) fn exaggerated_scales(scene: &Scene, object: usize) -> u32 {
    let exaggerated = scene.styles_of(object).filter(|style| style.exaggerate.amount > 0.0);
    exaggerated.map(|style| style.exaggerate.scales).max().unwrap_or(0)
}
