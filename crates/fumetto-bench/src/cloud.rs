//! The cloud with which drawing is measured: a bent plume that fills the same share of the picture (a
//! little over a third) with any number of puffs, so that times differ by the number alone.

use std::{f64::consts::TAU, fmt::Write as _, io, sync::Arc};

use fumetto::Assets;

/// What scenes call the file.
pub(crate) const FILE: &str = "plume.csv";

/// A puff's radius over the one with which neighbours overlap heavily. At half of it the gaps between
/// 1,000 puffs still close, and overdraw is that of a real cloud.
const RADIUS_SCALE: f64 = 0.5;

/// A file in memory.
#[derive(Clone, Debug)]
pub(crate) struct Cloud {
    csv: Arc<str>,
}

impl Cloud {
    /// A plume of `count` puffs.
    pub(crate) fn new(count: u32) -> Self {
        let mut csv = "x,y,z,radius\n".to_owned();
        for [x, y, z, radius] in (0..count).map(|index| puff(index, count, RADIUS_SCALE)) {
            // Writing to a string cannot fail.
            let _ = writeln!(csv, "{x:.6},{y:.6},{z:.6},{radius:.6}");
        }
        Self { csv: csv.into() }
    }
}

impl Assets for Cloud {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        if path == FILE { Ok(self.csv.as_bytes().to_vec()) } else { Err(io::ErrorKind::NotFound.into()) }
    }
}

/// Center and radius of a puff: anywhere in a tube that bends to the right and widens as it rises. Radii
/// shrink as the number grows, so that the puffs' volumes add up to the same.
fn puff(index: u32, count: u32, radius_scale: f64) -> [f64; 4] {
    let along = random(index, 0);
    let angle = TAU * random(index, 1);
    let off_axis = random(index, 2).sqrt();
    let shrink = (1000.0 / f64::from(count)).cbrt();
    let radius = 0.55 * radius_scale * (0.4 + 0.8 * along) * shrink;
    let offset = off_axis * (1.45 * (0.35 + 0.9 * along) - 0.8 * radius);
    let axis = [-3.6 + 6.6 * along * along, -0.8 + 3.2 * along];
    // The derivative of the axis.
    let tangent = [13.2 * along, 3.2];
    let length = tangent[0].hypot(tangent[1]);
    let across = offset * angle.cos() / length;
    [axis[0] - across * tangent[1], axis[1] + across * tangent[0], offset * angle.sin(), radius]
}

/// From 0 to below 1.
fn random(index: u32, stream: u32) -> f64 {
    f64::from(pcg(index.wrapping_mul(8).wrapping_add(stream))) / 4_294_967_296.0
}

/// The PCG-RXS-M-XS hash: Jarzynski and Olano, "Hash Functions for GPU Rendering", 2020.
fn pcg(input: u32) -> u32 {
    let state = input.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;

    #[test]
    fn the_plume_is_the_one_that_earlier_figures_were_taken_with() {
        let known = [[-3.460371, -0.720004, -0.209717, 0.233288], [-3.438383, -0.495194, 0.270977, 0.267129]];
        for (index, known) in (0..).zip(known) {
            let puff = puff(index, 1000, 1.0);
            assert!(puff.iter().zip(known).all(|(a, b)| (a - b).abs() < 2e-6), "{puff:?}");
        }
    }

    #[test]
    fn radii_shrink_so_that_volumes_add_up_to_the_same() {
        let volume = |count| (0..count).map(|index| puff(index, count, 0.5)[3].powi(3)).sum::<f64>();
        assert!((volume(8_000) / volume(1_000) - 1.0).abs() < 0.05);
        assert!((puff(0, 8_000, 0.5)[3] * 4.0 - 0.233288).abs() < 1e-6);
    }

    #[test]
    fn the_file_has_a_line_for_each_puff_and_no_other_file_is_there() {
        let cloud = Cloud::new(3);
        let text = String::from_utf8(cloud.read(FILE).unwrap()).unwrap();
        assert_eq!(text.lines().count(), 4);
        assert!(cloud.read("other.csv").is_err());
    }
}
