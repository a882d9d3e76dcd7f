//! Files without a header: numbers, and nothing else.

use fumetto_scene::Raw;
use glam::{DMat4, DVec3, Vec3};

use super::array::{Array, Number, malformed};
use super::dense::Strides;
use super::grid::Volume;
use crate::FormatError;

/// Reads a volume whose numbers lie as `raw` says: one grid, whose name is the file's.
///
/// # Errors
/// If the file is shorter than `raw` says, or has more than
/// [`MAX_VOLUME_NUMBERS`](crate::MAX_VOLUME_NUMBERS).
pub fn read_raw_volume(file: &str, bytes: &[u8], raw: &Raw) -> Result<Volume, FormatError> {
    let origin = Vec3::from(raw.origin_m).as_dvec3();
    let voxel: DVec3 = Vec3::from(raw.voxel_m).as_dvec3();
    let world_from_index = DMat4::from_translation(origin) * DMat4::from_scale(voxel);
    let array = Array { file, size: raw.size, channels: 1, world_from_index: Some(world_from_index) };
    let number = Number::from(raw.number);
    let length = array.count()? * number.size();
    let body = usize::try_from(raw.skip).ok().and_then(|skip| bytes.get(skip..)).unwrap_or_default();
    let numbers = body.get(..length).ok_or_else(|| {
        let [x, y, z] = raw.size;
        let problem = format!(
            "{x} x {y} x {z} numbers take {length} bytes, but after `skip` there are only {}; correct `raw`",
            body.len()
        );
        malformed(file, problem)
    })?;
    let strides = Strides::x_first(raw.size, 1).unwrap_or(Strides { axes: [0; 3], channel: 0 });
    array.volume(number.decode(numbers, raw.big_endian), strides)
}

#[cfg(test)]
mod tests {
    use fumetto_scene::RawNumber;

    use super::*;

    const RAW: Raw = Raw {
        size: [3, 2, 2],
        number: RawNumber::U16,
        big_endian: true,
        voxel_m: [0.5, 1.0, 2.0],
        origin_m: [1.0, 2.0, 3.0],
        skip: 5,
    };

    fn bytes() -> Vec<u8> {
        let numbers = (0..12_u16).flat_map(|number| (300 * number).to_be_bytes());
        [0xff; 5].into_iter().chain(numbers).collect()
    }

    #[test]
    fn numbers_lie_along_x_first() {
        let volume = read_raw_volume("a/head.raw", &bytes(), &RAW).expect("the file is long enough");
        let grid = &volume.grids[0];
        assert_eq!(grid.name, "head");
        assert_eq!(grid.voxels.at([2, 1, 0]), ([1500.0, 0.0, 0.0], true));
        assert_eq!(grid.voxels.at([0, 0, 1]), ([1800.0, 0.0, 0.0], true));
        let place = DMat4::from_cols_array_2d(&grid.world_from_index).transform_point3(DVec3::ONE);
        assert_eq!(place, DVec3::new(1.5, 3.0, 5.0));
    }

    #[test]
    fn what_is_too_short_or_too_large_is_refused() {
        let error =
            |raw: Raw| read_raw_volume("head.raw", &bytes(), &raw).expect_err("it does not fit").to_string();
        assert_eq!(
            error(Raw { skip: 6, ..RAW }),
            "head.raw: 3 x 2 x 2 numbers take 24 bytes, but after `skip` there are only 23; correct `raw`"
        );
        assert!(error(Raw { skip: u32::MAX, ..RAW }).contains("only 0"));
        assert!(error(Raw { size: [65_536; 3], ..RAW }).contains("numbers that are allowed"));
        assert!(error(Raw { size: [0, 1, 1], ..RAW }).contains("no voxel"));
    }
}
