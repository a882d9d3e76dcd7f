//! From numbers in all voxels of a box to those that are stored.

use super::grid::{BRICK_SIDE, BRICK_VOXELS, Brick, Voxels};

impl Voxels {
    /// Voxels of a dense box, stored where they differ from `background` in any channel; only those are
    /// active.
    ///
    /// `values` follow each other along x, then y, then z from the voxel `origin`, each with all its
    /// channels. `None` if they are not as many as `size` and `channels` say, `channels` is neither 1 nor
    /// 3, or the box ends beyond what an `i32` can count.
    #[must_use]
    pub fn from_dense(
        origin: [i32; 3],
        size: [u32; 3],
        channels: usize,
        values: &[f32],
        background: [f32; 3],
    ) -> Option<Self> {
        let strides = Strides::x_first(size, channels)?;
        Self::from_strided(origin, size, channels, &Strided { values, strides }, background)
    }

    /// The same of values in any order.
    pub(super) fn from_strided(
        origin: [i32; 3],
        size: [u32; 3],
        channels: usize,
        dense: &Strided<'_>,
        background: [f32; 3],
    ) -> Option<Self> {
        let count = size.iter().try_fold(channels, |count, &side| count.checked_mul(side as usize))?;
        if count != dense.values.len() || ![1, 3].contains(&channels) {
            return None;
        }
        let mut end = [0; 3];
        let mut first = [0; 3];
        for axis in 0..3 {
            end[axis] = origin[axis].checked_add_unsigned(size[axis])?;
            first[axis] = origin[axis].div_euclid(BRICK_SIDE) * BRICK_SIDE;
        }
        // What is beyond the channels counts for nothing, and is 0 everywhere.
        let mut background = background;
        background[channels..].fill(0.0);
        let mut voxels =
            Self { channels, background, bricks: Vec::new(), values: Vec::new(), tiles: Vec::new() };
        if count == 0 {
            return Some(voxels);
        }
        let corners = [origin, end];
        for x in (first[0]..end[0]).step_by(BRICK_SIDE as usize) {
            for y in (first[1]..end[1]).step_by(BRICK_SIDE as usize) {
                for z in (first[2]..end[2]).step_by(BRICK_SIDE as usize) {
                    voxels.push_brick_of(dense, corners, [x, y, z]);
                }
            }
        }
        Some(voxels)
    }

    /// Adds the brick at `origin` if any of its voxels differs from the background.
    fn push_brick_of(&mut self, dense: &Strided<'_>, [low, end]: [[i32; 3]; 2], origin: [i32; 3]) {
        let channels = self.channels;
        let start = self.values.len();
        let mut active = [0; 8];
        for voxel in 0..BRICK_VOXELS {
            let [x, y, z] = [voxel & 7, voxel >> 3 & 7, voxel >> 6];
            let index = [origin[0] + x as i32, origin[1] + y as i32, origin[2] + z as i32];
            let mut value = self.background;
            if (0..3).all(|axis| (low[axis]..end[axis]).contains(&index[axis])) {
                let place = [0, 1, 2].map(|axis| index[axis].abs_diff(low[axis]) as usize);
                value[..channels]
                    .iter_mut()
                    .enumerate()
                    .for_each(|(c, number)| *number = dense.number(place, c));
            }
            if value != self.background {
                active[z] |= 1 << (x + 8 * y);
            }
            self.values.extend_from_slice(&value[..channels]);
        }
        if active == [0; 8] {
            self.values.truncate(start);
        } else {
            self.bricks.push(Brick { origin, active });
        }
    }
}

/// A box full of numbers.
pub(super) struct Strided<'a> {
    pub(super) values: &'a [f32],
    pub(super) strides: Strides,
}

/// How far apart numbers are of which one follows the other along an axis.
pub(super) struct Strides {
    pub(super) axes: [usize; 3],
    pub(super) channel: usize,
}

impl Strides {
    /// Channels first, then x, then y, then z.
    pub(super) fn x_first([width, height, _]: [u32; 3], channels: usize) -> Option<Self> {
        let row = channels.checked_mul(width as usize)?;
        Some(Self { axes: [channels, row, row.checked_mul(height as usize)?], channel: 1 })
    }
}

impl Strided<'_> {
    /// A number of the voxel at `place` from the box's corner.
    fn number(&self, place: [usize; 3], channel: usize) -> f32 {
        let Strides { axes: [x, y, z], channel: between } = self.strides;
        self.values[place[0] * x + place[1] * y + place[2] * z + channel * between]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ORIGIN: [i32; 3] = [-3, 8, 16];
    const SIZE: [u32; 3] = [9, 10, 11];

    /// A number for each voxel of a box; some are the background.
    fn number(index: [i32; 3]) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|axis| index[axis] - ORIGIN[axis]);
        if (x + y + z) % 5 == 0 { 0.5 } else { (x + 9 * (y + 10 * z)) as f32 + 1.0 }
    }

    fn boxed(channels: usize) -> Voxels {
        let mut values = Vec::new();
        for (z, y, x) in (0..11).flat_map(|z| (0..10).flat_map(move |y| (0..9).map(move |x| (z, y, x)))) {
            let value = number([ORIGIN[0] + x, ORIGIN[1] + y, ORIGIN[2] + z]);
            values.extend(&[value, 0.5, -1.0][..channels]);
        }
        let background = [0.5, 0.5, -1.0];
        Voxels::from_dense(ORIGIN, SIZE, channels, &values, background).expect("as many values as voxels")
    }

    #[test]
    fn a_dense_box_keeps_its_numbers_and_its_place() {
        for channels in [1, 3] {
            let voxels = boxed(channels);
            assert_eq!(voxels.bricks.len(), 8);
            assert!(voxels.bricks.is_sorted_by_key(|brick| brick.origin));
            let mut active = 0;
            for (x, y, z) in (-9..9).flat_map(|x| (7..19).flat_map(move |y| (15..28).map(move |z| (x, y, z))))
            {
                let inside = (-3..6).contains(&x) && (8..18).contains(&y) && (16..27).contains(&z);
                let value = if inside { number([x, y, z]) } else { 0.5 };
                let expected = if channels == 3 { [value, 0.5, -1.0] } else { [value, 0.0, 0.0] };
                assert_eq!(voxels.at([x, y, z]), (expected, value != 0.5), "{x} {y} {z}");
                active += u64::from(value != 0.5);
            }
            assert_eq!(voxels.active_count(), active);
            assert_eq!(voxels.active_bounds(), Some([ORIGIN, [5, 17, 26]]));
        }
    }

    #[test]
    fn a_box_of_background_has_no_bricks() {
        let voxels = Voxels::from_dense([0; 3], [20; 3], 1, &[2.0; 8000], [2.0; 3]).expect("a whole box");
        assert!(voxels.bricks.is_empty() && voxels.values.is_empty());
        assert_eq!((voxels.active_count(), voxels.active_bounds()), (0, None));
        assert!(Voxels::from_dense([0; 3], [0, 5, 5], 1, &[], [0.0; 3]).is_some());
    }

    #[test]
    fn a_box_that_cannot_be_is_none() {
        let dense = |origin, size, channels, count| {
            Voxels::from_dense([origin; 3], size, channels, &vec![1.0; count], [0.0; 3]).is_some()
        };
        assert!(dense(i32::MAX - 2, [2; 3], 1, 8) && dense(i32::MIN, [2; 3], 1, 8));
        assert!(!dense(0, [2; 3], 1, 7) && !dense(0, [2; 3], 2, 16) && !dense(0, [2; 3], 0, 0));
        assert!(!dense(i32::MAX - 1, [2; 3], 1, 8) && !dense(0, [u32::MAX; 3], 1, 0));
    }
}
