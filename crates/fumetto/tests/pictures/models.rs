//! Models as text, to be read as if out of a file.

use std::{f32::consts::PI, fmt::Write as _};

/// A ball around the origin with exact normals: `rings` from pole to pole, twice as many round.
pub(crate) fn ball(radius: f32, rings: u32) -> String {
    let round = 2 * rings;
    let mut obj = String::new();
    for ring in 0..=rings {
        for step in 0..round {
            let (latitude, longitude) = (PI * ring as f32 / rings as f32, PI * step as f32 / rings as f32);
            let [x, y, z] =
                [latitude.sin() * longitude.cos(), latitude.cos(), -latitude.sin() * longitude.sin()];
            writeln!(obj, "v {} {} {}\nvn {x} {y} {z}", radius * x, radius * y, radius * z).unwrap();
        }
    }
    for ring in 0..rings {
        for step in 0..round {
            let corner = |ring: u32, step: u32| 1 + ring * round + step % round;
            let [a, b] = [corner(ring, step), corner(ring + 1, step)];
            let [c, d] = [corner(ring + 1, step + 1), corner(ring, step + 1)];
            if ring > 0 {
                writeln!(obj, "f {a}//{a} {b}//{b} {d}//{d}").unwrap();
            }
            if ring + 1 < rings {
                writeln!(obj, "f {b}//{b} {c}//{c} {d}//{d}").unwrap();
            }
        }
    }
    obj
}

/// A square in the plane z = 0 that looks along +z.
pub(crate) fn square(half: f32) -> String {
    format!(
        "v -{half} -{half} 0\nv {half} -{half} 0\nv {half} {half} 0\nv -{half} {half} 0\n\
         vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"
    )
}
