use super::At;
use crate::Puffs;
use crate::file::{PuffsFile, ShapeFile};

pub(super) fn puffs(at: &At<'_>, file: Option<&ShapeFile>) -> Puffs {
    let PuffsFile { variants, seed, spheres, tile, size } = match file {
        Some(ShapeFile::Puffs(puffs)) => *puffs,
        None => PuffsFile::default(),
    };
    if !tile.is_power_of_two() {
        let message = format!("`tile` must be a power of two, not {tile}");
        let nearest = tile.next_power_of_two();
        at.key("tile").error("not-a-power-of-two", message, format!("{} and {nearest} are", nearest / 2));
    }
    Puffs { variants, seed, spheres, tile_px: tile, size }
}
