//! Stands in for parts of the engine that are still being written.
use fumetto::{Engine, Error, Player, Shot};
use fumetto_formats::Image;
use std::fmt;

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
        f.write_str(&format!("{self:?}").to_lowercase())
    }
}
impl std::str::FromStr for Layer {
    type Err = ();
    fn from_str(name: &str) -> Result<Self, ()> {
        Self::ALL.into_iter().find(|layer| layer.to_string() == name).ok_or(())
    }
}
pub(crate) trait Pending {
    fn layer(&mut self, player: &Player, shot: &Shot, layer: Layer) -> Result<Image, Error>;
    fn atlas(&mut self, player: &Player) -> Result<Vec<(&'static str, Image)>, Error>;
}
impl Pending for Engine {
    fn layer(&mut self, player: &Player, shot: &Shot, _: Layer) -> Result<Image, Error> {
        self.picture(player, shot)
    }
    fn atlas(&mut self, player: &Player) -> Result<Vec<(&'static str, Image)>, Error> {
        let image = self.picture(player, &Shot::of(player.scene()))?;
        Ok(["normal", "depth", "coverage"].into_iter().map(|name| (name, image.clone())).collect())
    }
}
