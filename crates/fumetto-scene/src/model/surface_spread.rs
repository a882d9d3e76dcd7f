//! Which regions of the lattice particles touch: for those that stay where they are it is known beforehand, so
//! that what lies between two clouds is given no room.

use std::collections::BTreeSet;

use super::surface_plan::{BLOCK, REGION_CELLS};
use crate::Particle;

/// Cells that reaches are widened by: more than in the engine's `reach.wgsl`, which rounds otherwise.
const SLACK: f64 = 0.3;
/// More regions have no room.
const MOST_REGIONS: usize = 1 << 13;
/// Of particles and regions, so many pairs are looked at: a tenth of a second of work.
const MOST_PAIRS: u64 = 1 << 22;

/// What particles touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Spread {
    /// Regions in the box around all of them.
    pub(super) boxed: u64,
    /// Regions.
    pub(super) regions: u64,
    /// Faces of these that no two of them share.
    pub(super) faces: u64,
    /// Blocks in the boxes of all particles together.
    pub(super) entries: u64,
}

/// Cubes of `side` cells that a particle with this `center` and `radius_m` meets along one axis.
fn along(center: f32, radius_m: f32, cells_m: [f64; 2]) -> [i64; 2] {
    let [cell_m, side] = cells_m;
    let end = |sign: f64| {
        let cells = (f64::from(center) + sign * f64::from(radius_m)) / cell_m + sign * SLACK;
        // The cast saturates.
        (cells / side).floor() as i64
    };
    [end(-1.0), end(1.0)]
}

/// Cubes in a box.
fn product(axes: [[i64; 2]; 3]) -> u64 {
    let count = |[first, last]: [i64; 2]| last.saturating_sub(first).saturating_add(1).max(0).unsigned_abs();
    axes.map(count).into_iter().fold(1, u64::saturating_mul)
}

impl Spread {
    /// Of particles whose radii are multiplied by `size`, in cells of `cell_m`. Nothing where they touch more
    /// than there is room for.
    pub(super) fn of(particles: &[Particle], size: f32, cell_m: f32) -> Option<Self> {
        let mut regions = BTreeSet::new();
        let (mut pairs, mut entries) = (0_u64, 0_u64);
        let mut ends = [[i64::MAX, i64::MIN]; 3];
        for particle in particles {
            let meets = |side: u64| {
                let cells_m = [f64::from(cell_m), side as f64];
                particle.center.map(|center| along(center, particle.radius * size, cells_m))
            };
            entries = entries.saturating_add(product(meets(BLOCK)));
            let [x, y, z] = meets(REGION_CELLS);
            for (end, axis) in ends.iter_mut().zip([x, y, z]) {
                *end = [end[0].min(axis[0]), end[1].max(axis[1])];
            }
            pairs = pairs.saturating_add(product([x, y, z]));
            if pairs > MOST_PAIRS.max(8 * particles.len() as u64) {
                return None;
            }
            for k in z[0]..=z[1] {
                for j in y[0]..=y[1] {
                    regions.extend((x[0]..=x[1]).map(|i| [i, j, k]));
                }
            }
            if regions.len() > MOST_REGIONS {
                return None;
            }
        }
        let beyond = |region: &[i64; 3]| {
            let neighbours = (0..6_usize).map(|side| {
                let mut next = *region;
                next[side / 2] += if side % 2 == 0 { -1 } else { 1 };
                next
            });
            neighbours.filter(|next| !regions.contains(next)).count() as u64
        };
        let faces = regions.iter().map(beyond).sum();
        Some(Self { boxed: product(ends), regions: regions.len() as u64, faces, entries })
    }
}
