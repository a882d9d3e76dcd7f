//! The shape of what the engine will hand out besides pictures. Until it does, asking is refused.

use std::fmt;
use std::str::FromStr;

use anyhow::bail;
use fumetto::{Engine, Player, Shot};
use fumetto_formats::Image;

/// One layer of what a picture is made from.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(crate) enum Layer {
    Normal,
    Depth,
    Id,
    Alpha,
    Ink,
}

impl Layer {
    pub(crate) const ALL: [Self; 5] = [Self::Normal, Self::Depth, Self::Id, Self::Alpha, Self::Ink];
}

impl fmt::Display for Layer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Normal => "normal",
            Self::Depth => "depth",
            Self::Id => "id",
            Self::Alpha => "alpha",
            Self::Ink => "ink",
        })
    }
}

impl FromStr for Layer {
    type Err = ();

    fn from_str(name: &str) -> Result<Self, ()> {
        Self::ALL.into_iter().find(|layer| layer.to_string() == name).ok_or(())
    }
}

/// Calls of the engine to come.
pub(crate) trait Pending {
    fn layer(&mut self, player: &Player, shot: &Shot, layer: Layer) -> anyhow::Result<Image>;
    fn atlas(&mut self, player: &Player) -> anyhow::Result<Vec<(&'static str, Image)>>;
}

impl Pending for Engine {
    fn layer(&mut self, _: &Player, _: &Shot, layer: Layer) -> anyhow::Result<Image> {
        bail!("this version of fumetto cannot write the layer {layer} yet; leave --layers out")
    }

    fn atlas(&mut self, _: &Player) -> anyhow::Result<Vec<(&'static str, Image)>> {
        bail!("this version of fumetto cannot export the pictures of puffs yet")
    }
}
