//! A model for measuring lines.

use std::{
    f64::consts::{PI, TAU},
    fmt::Write as _,
    io,
    sync::Arc,
};

use fumetto::Assets;

/// A model in memory.
#[derive(Clone, Debug)]
pub(crate) struct Boulder(Arc<str>);

impl Boulder {
    /// A ball with bumps, of about `triangles`: it has contours within its outline.
    pub(crate) fn new(triangles: u32) -> Self {
        let rings = (f64::from(triangles) / 4.0).sqrt().round() as u32;
        let round = 2 * rings;
        let mut obj = String::new();
        for ring in 0..=rings {
            for step in 0..round {
                let latitude = PI * f64::from(ring) / f64::from(rings);
                let longitude = TAU * f64::from(step) / f64::from(round);
                let bump = (5.0 * latitude).cos() * (6.0 * longitude).sin() * latitude.sin();
                let radius = 1.5 + 0.15 * bump;
                let [x, z] = [longitude.cos(), -longitude.sin()].map(|part| radius * latitude.sin() * part);
                // Writing to a string cannot fail.
                let _ = writeln!(obj, "v {x:.6} {:.6} {z:.6}", radius * latitude.cos());
            }
        }
        for ring in 0..rings {
            for step in 0..round {
                let corner = |ring: u32, step: u32| 1 + ring * round + step % round;
                let [a, b] = [corner(ring, step), corner(ring + 1, step)];
                let [c, d] = [corner(ring + 1, step + 1), corner(ring, step + 1)];
                let _ = writeln!(obj, "f {a} {b} {c}\nf {a} {c} {d}");
            }
        }
        Self(obj.into())
    }
}

impl Assets for Boulder {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        if path == "boulder.obj" {
            Ok(self.0.as_bytes().to_vec())
        } else {
            Err(io::ErrorKind::NotFound.into())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_boulder_has_about_as_many_triangles_as_said() {
        for size in [5_000, 50_000] {
            let faces = Boulder::new(size).0.lines().filter(|line| line.starts_with('f')).count() as f64;
            assert!((faces / f64::from(size) - 1.0).abs() < 0.03, "{faces}");
        }
    }
}
