use super::At;
use crate::Puffs;
use crate::file::{PuffsFile, ShapeFile};
use crate::limits::MAX_ATLAS_PX;

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
    let width = variants.saturating_mul(tile);
    if width > MAX_ATLAS_PX {
        let message = format!("{variants} puffs of {tile} pixels make an atlas {width} pixels wide");
        at.error("atlas-too-wide", message, format!("`variants` times `tile` may be at most {MAX_ATLAS_PX}"));
    }
    Puffs { variants, seed, spheres, tile_px: tile, size }
}
