//! Where voxels are in the world: the maps of OpenVDB's `math/Maps.h`.

use glam::{DMat4, DVec3};

use super::Trouble;
use super::bytes::Bytes;
use crate::excerpt::excerpt;
use crate::volume::grid::has_inverse;

/// Reads a map by its name.
pub(super) fn read(bytes: &mut Bytes<'_>) -> Result<[[f64; 4]; 4], Trouble> {
    let name = bytes.string()?;
    let map = match name {
        b"UniformScaleMap" | b"ScaleMap" => {
            let map = DMat4::from_scale(vector(bytes)?);
            // The size of a voxel and inverses, which follow from the scale.
            bytes.take(4 * 24)?;
            map
        }
        b"UniformScaleTranslateMap" | b"ScaleTranslateMap" => {
            let offset = vector(bytes)?;
            let map = DMat4::from_translation(offset) * DMat4::from_scale(vector(bytes)?);
            bytes.take(4 * 24)?;
            map
        }
        b"TranslationMap" => DMat4::from_translation(vector(bytes)?),
        b"AffineMap" | b"UnitaryMap" => {
            // Rows that are multiplied by a row vector from the left are columns to us.
            let mut map = [0.0; 16];
            for number in &mut map {
                *number = bytes.f64()?;
            }
            DMat4::from_cols_array(&map)
        }
        _ => {
            let name = excerpt(name);
            return Err(Trouble::Unsupported(format!(
                "its transform is a `{name}`, and only affine ones are read"
            )));
        }
    };
    if !has_inverse(&map) {
        let problem = "its transform has no inverse, so its voxels have no size; export it again";
        return Err(Trouble::Damaged(problem.to_owned()));
    }
    Ok(map.to_cols_array_2d())
}

fn vector(bytes: &mut Bytes<'_>) -> Result<DVec3, Trouble> {
    Ok(DVec3::new(bytes.f64()?, bytes.f64()?, bytes.f64()?))
}
