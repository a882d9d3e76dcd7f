//! Solids as one mesh in binary PLY.

use std::io::Write;

use super::{Solid, materials, place_of};
use crate::WriteError;

/// Writes solids as one mesh in PLY, binary and little-endian. Every face has the number of its `material`,
/// whose names the comments list, and its colour.
///
/// # Errors
/// If a solid is not sound, there are more than 2³¹ vertices, or `out` refuses the bytes.
pub fn write_solids_ply(solids: &[Solid], mut out: impl Write) -> Result<(), WriteError> {
    solids.iter().try_for_each(Solid::check)?;
    let vertices: usize = solids.iter().map(|solid| solid.positions.len()).sum();
    let faces: usize = solids.iter().map(Solid::triangle_count).sum();
    // Readers take numbers of vertices for signed.
    if i32::try_from(vertices).is_err() {
        return Err(WriteError::TooManyVertices { vertices });
    }
    let materials = materials(solids);
    write!(out, "ply\nformat binary_little_endian 1.0\ncomment Fumetto: metres, +Y up\n")?;
    for (number, (name, _)) in materials.iter().enumerate() {
        writeln!(out, "comment material {number} {}", name.replace(char::is_control, "_"))?;
    }
    writeln!(out, "element vertex {vertices}")?;
    for name in ["x", "y", "z", "nx", "ny", "nz"] {
        writeln!(out, "property float {name}")?;
    }
    write!(out, "element face {faces}\nproperty list uchar int vertex_indices\nproperty int material\n")?;
    for name in ["red", "green", "blue"] {
        writeln!(out, "property uchar {name}")?;
    }
    writeln!(out, "end_header")?;

    for solid in solids {
        for (position, normal) in solid.positions.iter().zip(&solid.normals) {
            for along in position.iter().chain(normal) {
                out.write_all(&along.to_le_bytes())?;
            }
        }
    }
    let mut first = 0;
    for solid in solids {
        for group in &solid.groups {
            let (material, colour) = (place_of(&materials, group) as u32, group.colour.to_srgb8());
            for triangle in &group.triangles {
                out.write_all(&[3])?;
                for corner in triangle {
                    out.write_all(&(first + corner).to_le_bytes())?;
                }
                out.write_all(&material.to_le_bytes())?;
                out.write_all(&colour)?;
            }
        }
        first += solid.positions.len() as u32;
    }
    Ok(())
}
