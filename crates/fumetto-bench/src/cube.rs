//! The cloud with which surfaces are measured: a cube full of particles that overlap as much whatever their
//! number. `tools/bench/surfaces.py` makes the same ones.

use std::{io, sync::Arc};

use fumetto::Assets;

/// What scenes call the file: a sequence, so that every frame's surface is made anew.
pub(crate) const FILE: &str = "cube.#.ply";

/// Likewise, where every other particle is moved along x, by so many metres.
pub(crate) const SPLIT: [(&str, f64); 2] = [("near.#.ply", 4.0), ("far.#.ply", 100.0)];

/// Along each side of the cube, in metres.
pub(crate) const SIDE_M: f64 = 2.0;

/// Powers of the inverse of the number whose fourth power is one more than itself: the shares of a line
/// that spread points evenly in space (Roberts 2018, "The unreasonable effectiveness of quasirandom
/// sequences").
const SHARES: [f64; 3] = [0.819_172_513_396_164_4, 0.671_043_606_703_789_3, 0.549_700_477_901_970_3];

/// Files in memory, the same for every frame.
#[derive(Clone, Debug)]
pub(crate) struct Cube {
    ply: Arc<[u8]>,
    split: [Arc<[u8]>; 2],
}

impl Cube {
    /// A cube of `count` particles.
    pub(crate) fn new(count: u32) -> Self {
        Self { ply: ply(count, 0.0), split: SPLIT.map(|(_, apart_m)| ply(count, apart_m)) }
    }
}

/// A file of `count` particles, every other of which is moved along x.
fn ply(count: u32, apart_m: f64) -> Arc<[u8]> {
    let names = ["x", "y", "z", "radius"].map(|name| format!("property float {name}\n")).concat();
    let header = format!("ply\nformat binary_little_endian 1.0\nelement vertex {count}\n{names}end_header\n");
    let radius = radius_m(count) as f32;
    let mut ply = header.into_bytes();
    for index in 0..count {
        let mut place = SHARES.map(|share| SIDE_M * ((share * f64::from(index)).fract() - 0.5));
        place[0] += f64::from(index % 2) * apart_m;
        ply.extend(place.map(|metres| metres as f32).into_iter().chain([radius]).flat_map(f32::to_le_bytes));
    }
    ply.into()
}

/// Particles are so large that about 8 overlap everywhere.
pub(crate) fn radius_m(count: u32) -> f64 {
    2.5 * SIDE_M / 2.0 / f64::from(count).cbrt()
}

impl Assets for Cube {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        let is_frame_of = |file: &str| {
            file.split_once('#').is_some_and(|(stem, end)| path.starts_with(stem) && path.ends_with(end))
        };
        let mut files =
            [FILE, SPLIT[0].0, SPLIT[1].0].into_iter().zip([&self.ply, &self.split[0], &self.split[1]]);
        let ours = files.find(|(file, _)| is_frame_of(file));
        ours.map_or_else(|| Err(io::ErrorKind::NotFound.into()), |(_, ply)| Ok(ply.to_vec()))
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;

    #[test]
    fn the_cube_is_the_one_that_the_comparison_makes() {
        let bytes = Cube::new(3).read("cube.7.ply").unwrap();
        let floats: Vec<f32> = bytes[bytes.len() - 48..]
            .chunks_exact(4)
            .map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap()))
            .collect();
        let radius = 1.733_403;
        let known = [
            [-1.0, -1.0, -1.0, radius],
            [0.638_345, 0.342_087_2, 0.099_400_96, radius],
            [0.276_690_06, -0.315_825_6, -0.801_198_1, radius],
        ];
        assert!(floats.iter().zip(known.as_flattened()).all(|(a, b)| (a - b).abs() < 1e-6), "{floats:?}");
        assert!(Cube::new(3).read("other.ply").is_err());
    }

    #[test]
    fn every_other_particle_is_moved() {
        let cube = Cube::new(2);
        let last_x = |path: &str| {
            let bytes = cube.read(path).unwrap();
            f32::from_le_bytes(bytes[bytes.len() - 16..][..4].try_into().unwrap())
        };
        let [whole, near, far] = ["cube.1.ply", "near.1.ply", "far.1.ply"].map(last_x);
        assert!(
            (near - whole - 4.0).abs() < 1e-5 && (far - whole - 100.0).abs() < 1e-4,
            "{whole} {near} {far}"
        );
    }
}
