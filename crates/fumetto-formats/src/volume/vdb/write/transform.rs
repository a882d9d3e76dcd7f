//! Where voxels are in the world, as the simplest of OpenVDB's maps that can say it.

use glam::{DMat3, DMat4, DVec3};

use super::put_string;
use crate::volume::grid::has_inverse;

/// Appends the map's name and numbers.
pub(super) fn put(bytes: &mut Vec<u8>, world_from_index: &[[f64; 4]; 4]) -> Result<(), String> {
    let map = DMat4::from_cols_array_2d(world_from_index);
    if !has_inverse(&map) {
        return Err("its transform has to be affine and to have an inverse".to_owned());
    }
    let axes = DMat3::from_mat4(map);
    let scale = DVec3::new(axes.x_axis.x, axes.y_axis.y, axes.z_axis.z);
    if axes != DMat3::from_diagonal(scale) {
        put_string(bytes, b"AffineMap");
        // Our columns are OpenVDB's rows, which are multiplied by a row vector from the left.
        world_from_index.as_flattened().iter().for_each(|number| bytes.extend(number.to_le_bytes()));
        return Ok(());
    }
    let uniform = scale == DVec3::splat(scale.x);
    put_string(bytes, if uniform { b"UniformScaleTranslateMap" } else { b"ScaleTranslateMap" });
    let inverse = scale.recip();
    // The last four follow from the scale: a voxel's size, and what gradients are computed with.
    for vector in [map.w_axis.truncate(), scale, scale.abs(), inverse, inverse * inverse, inverse / 2.0] {
        vector.to_array().iter().for_each(|number| bytes.extend(number.to_le_bytes()));
    }
    Ok(())
}
