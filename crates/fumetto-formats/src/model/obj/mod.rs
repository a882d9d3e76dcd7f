//! Wavefront OBJ.
//!
//! It is read here rather than through a crate: `tobj` 4, the kept one, stops the program at a `Kd` of
//! two numbers, mixes up the vertices of a group where only some have texture coordinates, covers what
//! is outside a concave face, and cannot say in which line something is wrong. Our part of the format is
//! small: statements in [`lines`], shapes in [`statements`], faces of many corners in [`polygon`], parts
//! in [`groups`], materials in [`library`].

mod groups;
mod library;
mod lines;
mod polygon;
mod statements;

use self::library::Library;
use self::statements::Shapes;
use super::companions::Companions;
use super::mend::Label;
use super::rig::Rig;
use super::{Model, ModelOptions};
use crate::FormatError;
use crate::excerpt::excerpt;
use crate::notes::Notes;

/// Reads the shapes of an OBJ file, and its materials.
pub(super) fn read(
    path: &str,
    bytes: &[u8],
    options: ModelOptions,
    mut companions: Companions<'_>,
) -> Result<Model, FormatError> {
    let mut notes = Notes::new(path);
    let shapes = Shapes::read(path, bytes, &mut notes)?;
    let mut library = Library::read(&shapes.libraries, &mut companions, &mut notes);
    let mut parts = Vec::new();
    for group in &shapes.groups {
        let name = &*shapes.names[group.name];
        let material = group.material.map(|material| &*shapes.names[material]);
        let material = library.material(material, &mut companions, &mut notes);
        let element = format!("group \"{}\"", excerpt(name.as_bytes()));
        let label = Label { element: &element, name, material };
        parts.extend(group.surface(&shapes.vertices).finish(label, options, &mut notes));
    }
    if parts.is_empty() {
        return Err(FormatError::NoTriangles { file: path.to_owned() });
    }
    let (materials, textures) = library.finish();
    let rig = Rig::still(0..parts.len());
    Ok(Model { parts, materials, textures, notes: notes.finish(), rig })
}
