//! What a drawing is on.

use fumetto_formats::Paper;
use fumetto_scene::{Background, Colour, Scene};

use crate::{Assets, Error, assets::load_image};

/// Colours that stand for a gradient: it is mixed in linear light, and programs that show drawings mix encoded
/// colours, which are the same for so small steps.
const STOPS: u8 = 33;

pub(super) fn paper(scene: &Scene, assets: &dyn Assets) -> Result<Paper, Error> {
    Ok(match &scene.background {
        Background::Transparent => Paper::Clear,
        // Pores are too many for shapes.
        Background::Colour(colour) | Background::Paper(colour) => Paper::Colour(colour.to_srgb8()),
        Background::Gradient { top, bottom } => {
            let stop = |stop: u8| mixed(*top, *bottom, f32::from(stop) / f32::from(STOPS - 1));
            Paper::Gradient((0..STOPS).map(stop).collect())
        }
        Background::Image(path) => Paper::Image(load_image(assets, path)?),
    })
}

fn mixed(from: Colour, to: Colour, share: f32) -> [u8; 3] {
    let mix = |channel: usize| from.linear[channel] + (to.linear[channel] - from.linear[channel]) * share;
    Colour { linear: [0, 1, 2].map(mix) }.to_srgb8()
}
