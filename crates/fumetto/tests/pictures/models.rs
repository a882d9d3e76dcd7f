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

/// Boxes of 2 by 2 by 2 around `middles`.
pub(crate) fn boxes(middles: &[[f32; 3]]) -> String {
    let mut obj = String::new();
    for [x, y, z] in middles {
        for corner in 0..8 {
            let side = |axis: u32| 2.0 * ((corner >> axis) & 1) as f32 - 1.0;
            writeln!(obj, "v {} {} {}", x + side(0), y + side(1), z + side(2)).unwrap();
        }
        obj += "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n";
    }
    obj
}

/// A square like [`square`], of `cells` by `cells` smaller ones.
pub(crate) fn grid(half: f32, cells: u32) -> String {
    let mut obj = String::new();
    let at = |step: u32| half * (2.0 * step as f32 / cells as f32 - 1.0);
    for y in 0..=cells {
        for x in 0..=cells {
            writeln!(obj, "v {} {} 0", at(x), at(y)).unwrap();
        }
    }
    for y in 0..cells {
        for x in 0..cells {
            let a = 1 + y * (cells + 1) + x;
            writeln!(obj, "f {a} {} {} {}", a + 1, a + cells + 2, a + cells + 1).unwrap();
        }
    }
    obj
}
