//! Matter gathered into balls of the size of lobes.

use fumetto_formats::BRICK_SIDE;
use fumetto_scene::Particle;
use glam::{DMat4, DVec3};

use super::samples::{IN_BRICK, SIDE};

/// Lobes along the longest side, if the scene does not say how large they are.
const LOBES: f64 = 8.0;

/// Balls along the longest side, at most.
const FINEST: f64 = 16.0;

/// Balls that there may be.
pub(crate) const MAX_LOBES: u32 = 17 * 17 * 17;

/// Voxels along the sides of what is gathered at once.
const STRIDE: usize = 2;

/// Matter that is being gathered.
pub(super) struct Lobes {
    world_from_index: DMat4,
    low: DVec3,
    spacing_m: f64,
    radius_m: f64,
    cells: [usize; 3],
    /// Sums of places times matter, and of matter.
    sums: Vec<(DVec3, f64)>,
}

impl Lobes {
    /// For matter in the box between two indices.
    pub(super) fn new(world_from_index: DMat4, [least, most]: [DVec3; 2], lobe_m: Option<f32>) -> Self {
        let corner = |corner: u8| {
            let upper = [0, 1, 2].map(|axis| corner >> axis & 1 == 1);
            let index = DVec3::from([0, 1, 2].map(|i| if upper[i] { most[i] } else { least[i] }));
            world_from_index.transform_point3(index)
        };
        let low = (0..8).map(corner).reduce(DVec3::min).unwrap_or_default();
        let high = (0..8).map(corner).reduce(DVec3::max).unwrap_or_default();
        let extent = high - low;
        let longest = extent.max_element().max(f64::MIN_POSITIVE);
        // In steps of a quarter of an octave: lobes seldom change while smoke grows.
        let stepped = || (((longest / LOBES).log2() * 4.0).ceil() / 4.0).exp2();
        let radius_m = lobe_m.map_or_else(stepped, f64::from);
        let spacing_m = (0.5 * radius_m).max(longest / FINEST);
        let cells = extent.to_array().map(|side| (side / spacing_m) as usize + 1);
        let sums = vec![(DVec3::ZERO, 0.0); cells.iter().product()];
        Self { world_from_index, low, spacing_m, radius_m, cells, sums }
    }

    /// Adds a brick that begins at `origin`.
    pub(super) fn add(&mut self, origin: [i32; 3], density: &[f32; IN_BRICK]) {
        let steps = || (0..BRICK_SIDE as usize).step_by(STRIDE);
        for (z, y, x) in steps().flat_map(|z| steps().flat_map(move |y| steps().map(move |x| (z, y, x)))) {
            let mut matter = 0.0;
            for corner in 0..8 {
                let at = [x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2)];
                matter += f64::from(density[at[0] + SIDE * (at[1] + SIDE * at[2])]);
            }
            if matter > 0.0 {
                let first = DVec3::from(origin.map(f64::from)) + DVec3::new(x as f64, y as f64, z as f64);
                self.add_at(self.world_from_index.transform_point3(first + 0.5), matter);
            }
        }
    }

    fn add_at(&mut self, place: DVec3, matter: f64) {
        let at = ((place - self.low) / self.spacing_m).to_array();
        let [x, y, z] = [0, 1, 2].map(|axis| (at[axis].max(0.0) as usize).min(self.cells[axis] - 1));
        let sum = &mut self.sums[(z * self.cells[1] + y) * self.cells[0] + x];
        sum.0 += place * matter;
        sum.1 += matter;
    }

    /// Balls, of which the one with the most matter has mass 1: none, or at least two.
    pub(super) fn balls(&self) -> Vec<Particle> {
        let most = self.sums.iter().map(|sum| sum.1).fold(0.0, f64::max);
        let ball = |&(places, matter): &(DVec3, f64)| Particle {
            center: (places / matter).as_vec3().to_array(),
            radius: self.radius_m as f32,
            mass: (matter / most) as f32,
        };
        let mut balls: Vec<Particle> = self.sums.iter().filter(|sum| sum.1 > 0.0).map(ball).collect();
        if let [only] = balls[..] {
            balls.push(Particle { mass: 0.0, ..only });
        }
        balls
    }
}
