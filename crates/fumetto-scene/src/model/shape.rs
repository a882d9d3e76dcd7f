use crate::{Puffs, Surface, Volume};

/// How particles get a shape.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Every particle is a billboard of its own.
    Puffs(Puffs),
    /// All particles together have one skin.
    Surface(Surface),
    /// All particles together are a field of matter that light goes through.
    Volume(Volume),
}

impl Shape {
    /// The drawn radius over the particle's radius.
    #[must_use]
    pub fn size(&self) -> f32 {
        match self {
            Self::Puffs(puffs) => puffs.size,
            Self::Surface(surface) => surface.size,
            Self::Volume(volume) => volume.size,
        }
    }

    /// The puffs, if it is these.
    #[must_use]
    pub fn puffs(&self) -> Option<&Puffs> {
        match self {
            Self::Puffs(puffs) => Some(puffs),
            Self::Surface(_) | Self::Volume(_) => None,
        }
    }

    /// The surface, if it is one.
    #[must_use]
    pub fn surface(&self) -> Option<&Surface> {
        match self {
            Self::Surface(surface) => Some(surface),
            Self::Puffs(_) | Self::Volume(_) => None,
        }
    }

    /// The volume, if it is one.
    #[must_use]
    pub fn volume(&self) -> Option<&Volume> {
        match self {
            Self::Volume(volume) => Some(volume),
            Self::Puffs(_) | Self::Surface(_) => None,
        }
    }
}
