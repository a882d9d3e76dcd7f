//! Images that styles name.

use std::collections::BTreeMap;

use fumetto_scene::{Background, Ink, InkMethod, Object, Ramp, RampImage, Scene, StrokeTexture};

use crate::{
    Assets, Error,
    assets::load_image,
    gpu::Gpu,
    ink::StrokeTextures,
    tone::{Backdrop, Ramps},
};

pub(super) fn load_ramps(gpu: &Gpu, scene: &Scene, assets: &dyn Assets) -> Result<Ramps, Error> {
    // Objects often share a ramp image; each file is read once.
    let mut images = BTreeMap::new();
    for object in &scene.objects {
        if let Ramp::Image(RampImage { path, .. }) = &object.style.ramp
            && !images.contains_key(path)
        {
            images.insert(path.clone(), load_image(assets, path)?);
        }
    }
    Ok(Ramps::new(gpu, &scene.objects, &images))
}

pub(super) fn load_backdrop(gpu: &Gpu, scene: &Scene, assets: &dyn Assets) -> Result<Backdrop, Error> {
    let image = match &scene.background {
        Background::Image(path) => Some(load_image(assets, path)?),
        _ => None,
    };
    Ok(Backdrop::new(gpu, &scene.background, image.as_ref()))
}

pub(super) fn load_strokes(gpu: &Gpu, scene: &Scene, assets: &dyn Assets) -> Result<StrokeTextures, Error> {
    let mut images = BTreeMap::new();
    for stroke in scene.objects.iter().flat_map(Object::inks).flat_map(Ink::strokes) {
        if let StrokeTexture::File(path) = &stroke.texture
            && !images.contains_key(path)
        {
            images.insert(path.clone(), load_image(assets, path)?);
        }
    }
    Ok(StrokeTextures::new(gpu, &images))
}

/// For each object the angle from which on edges are creases, where it wants lines along them.
pub(super) fn crease_degs(scene: &Scene) -> Vec<Option<f32>> {
    let wanted = |ink: &Ink| ink.on && matches!(ink.method, InkMethod::Vector | InkMethod::Hybrid);
    let inks = scene.objects.iter().map(|object| &object.style.ink);
    inks.map(|ink| wanted(ink).then_some(ink.crease_deg)).collect()
}
