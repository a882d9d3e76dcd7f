//! Particles for other programs, and for another scene: the columns are those that are read.

use std::io::Write;

use fumetto_scene::Particle;

use crate::WriteError;

const COLUMNS: [&str; 5] = ["x", "y", "z", "radius", "mass"];

fn row(particle: &Particle) -> [f32; 5] {
    let [x, y, z] = particle.center;
    [x, y, z, particle.radius, particle.mass]
}

/// Writes particles as the vertices of a binary PLY file.
///
/// # Errors
/// If `out` refuses the bytes.
pub fn write_particles_ply(particles: &[Particle], mut out: impl Write) -> Result<(), WriteError> {
    write!(out, "ply\nformat binary_little_endian 1.0\ncomment Fumetto: metres, +Y up\n")?;
    writeln!(out, "element vertex {}", particles.len())?;
    for name in COLUMNS {
        writeln!(out, "property float {name}")?;
    }
    writeln!(out, "end_header")?;
    for value in particles.iter().flat_map(row) {
        out.write_all(&value.to_le_bytes())?;
    }
    Ok(())
}

/// Writes particles as a CSV table.
///
/// # Errors
/// If `out` refuses the bytes.
pub fn write_particles_csv(particles: &[Particle], mut out: impl Write) -> Result<(), WriteError> {
    writeln!(out, "{}", COLUMNS.join(","))?;
    for particle in particles {
        // The shortest text that reads as the same number.
        writeln!(out, "{}", row(particle).map(|value| value.to_string()).join(","))?;
    }
    Ok(())
}
