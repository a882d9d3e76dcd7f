//! glTF 2.0, whose JSON is understood by the `gltf-json` crate.
//!
//! The crate on top of it, `gltf`, is not used: it reads accessors without looking whether the buffer
//! is as long as they say, and stops the program where it is not. So what the document refers to is
//! looked up here, and every look may fail: buffers in [`container`] and [`document`], their numbers in
//! [`accessor`], triangles in [`mesh`], colours in [`material`], nodes in [`scene`] and [`instances`],
//! what moves them in [`animation`].

mod accessor;
mod animation;
mod container;
mod document;
mod instances;
mod material;
mod mesh;
mod scene;

use self::document::Document;
use self::material::Materials;
use super::companions::Companions;
use super::{Model, ModelOptions};
use crate::FormatError;
use crate::notes::Notes;

/// Reads the default scene of a glTF file, in text or binary: its first bytes tell.
pub(super) fn read(
    path: &str,
    bytes: &[u8],
    options: ModelOptions,
    mut companions: Companions<'_>,
) -> Result<Model, FormatError> {
    let mut notes = Notes::new(path);
    let document = Document::read(path, bytes, &mut companions, &mut notes)?;
    let visits = scene::visit(&document, &mut notes)?;
    let mut nodes = scene::nodes(&document, &visits, &mut notes)?;
    mesh::check_size(&document, &visits, &nodes)?;

    let mut materials = Materials::new(&document);
    let mut meshes = mesh::Meshes::new(&document, options);
    for (visit, node) in visits.iter().zip(&mut nodes) {
        if let Some(mesh) = document.root.nodes[visit.node].mesh {
            node.parts = meshes.read(mesh.value(), &mut materials, &mut companions, &mut notes)?;
        }
    }
    let parts = meshes.finish();
    if !nodes.iter().any(|node| !node.parts.is_empty() && node.copies() > 0) {
        return Err(FormatError::NoTriangles { file: path.to_owned() });
    }
    let tracks = animation::tracks(&document, &visits, &nodes, &mut notes)?;
    let (materials, textures) = materials.finish();
    let rig = super::rig::Rig { nodes, tracks };
    Ok(Model { parts, materials, textures, notes: notes.finish(), rig })
}
