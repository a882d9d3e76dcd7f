/// McGuire's puffs: every particle is a billboard of one of a few pre-rendered bundles of balls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Puffs {
    /// How many different puffs there are, 1 to 16.
    pub variants: u32,
    /// What they are made from.
    pub seed: u32,
    /// Balls in each puff, 1 to 256.
    pub spheres: u32,
    /// Width of a puff's picture in pixels, 16 to 512.
    pub tile_px: u32,
    /// The puff's radius over the particle's radius; above zero.
    pub size: f32,
}
