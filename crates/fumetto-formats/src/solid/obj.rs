//! Wavefront OBJ, and its materials as MTL.

use std::io::Write;

use fumetto_scene::Colour;

use super::{Solid, materials};
use crate::WriteError;

/// Writes solids as OBJ: an `o` for each, and a `usemtl` for each of its groups. `library` is the name of
/// the file that [`write_mtl`] fills.
///
/// # Errors
/// If a solid is not sound, or `out` refuses the bytes.
pub fn write_obj(solids: &[Solid], library: &str, mut out: impl Write) -> Result<(), WriteError> {
    writeln!(out, "# Fumetto: metres, +Y up")?;
    writeln!(out, "mtllib {library}")?;
    // Vertices are numbered from 1, through the whole file.
    let mut first = 1;
    for solid in solids {
        solid.check()?;
        writeln!(out, "o {}", word(&solid.name))?;
        for [x, y, z] in &solid.positions {
            writeln!(out, "v {x} {y} {z}")?;
        }
        for [x, y, z] in &solid.normals {
            writeln!(out, "vn {x} {y} {z}")?;
        }
        for group in &solid.groups {
            writeln!(out, "usemtl {}", word(&group.material))?;
            for triangle in &group.triangles {
                let [a, b, c] = triangle.map(|corner| first + u64::from(corner));
                writeln!(out, "f {a}//{a} {b}//{b} {c}//{c}")?;
            }
        }
        first += solid.positions.len() as u64;
    }
    Ok(())
}

/// Writes the materials of solids, as sRGB.
///
/// # Errors
/// If `out` refuses the bytes.
pub fn write_mtl(solids: &[Solid], mut out: impl Write) -> Result<(), WriteError> {
    writeln!(out, "# Fumetto")?;
    for (name, colour) in materials(solids) {
        let [r, g, b] = srgb(colour);
        writeln!(out, "newmtl {}\nKd {r:.4} {g:.4} {b:.4}\nillum 1", word(name))?;
    }
    Ok(())
}

fn srgb(colour: Colour) -> [f32; 3] {
    colour.to_srgb8().map(|channel| f32::from(channel) / 255.0)
}

/// As one word: readers end a name at the first space.
fn word(name: &str) -> String {
    name.replace(|c: char| c.is_whitespace() || c.is_control(), "_")
}
