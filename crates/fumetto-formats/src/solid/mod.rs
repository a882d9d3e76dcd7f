//! Triangles for other programs.

mod glb;
mod obj;
mod ply;

use fumetto_scene::Colour;

pub use self::{
    glb::write_glb,
    obj::{write_mtl, write_obj},
    ply::write_solids_ply,
};
use crate::WriteError;

/// An object's triangles at one moment, in metres, +Y up.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// What it is called.
    pub name: String,
    /// Where its vertices are. Triangles share them.
    pub positions: Vec<[f32; 3]>,
    /// Unit vectors, one for each vertex.
    pub normals: Vec<[f32; 3]>,
    /// Its triangles, by material.
    pub groups: Vec<Group>,
}

/// The triangles of a solid that are of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// What the material is called; groups of one name are of one material.
    pub material: String,
    /// The material's colour.
    pub colour: Colour,
    /// Numbers of vertices, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Solid {
    /// How many triangles all groups have.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        self.groups.iter().map(|group| group.triangles.len()).sum()
    }

    /// Refuses what no reader could make sense of.
    fn check(&self) -> Result<(), WriteError> {
        let refused = |problem| Err(WriteError::Solid { name: self.name.clone(), problem });
        if self.normals.len() != self.positions.len() {
            return refused("it has not as many normals as vertices");
        }
        if !self.positions.iter().chain(&self.normals).flatten().all(|along| along.is_finite()) {
            return refused("a vertex of it lies nowhere; look at its `transform` and at its model");
        }
        let count = self.positions.len();
        let mut corners = self.groups.iter().flat_map(|group| group.triangles.as_flattened());
        if corners.any(|&corner| corner as usize >= count) {
            return refused("a triangle of it has a corner that is no vertex");
        }
        Ok(())
    }
}

/// Every material once, in the order in which groups name them.
fn materials(solids: &[Solid]) -> Vec<(&str, Colour)> {
    let mut materials: Vec<(&str, Colour)> = Vec::new();
    for group in solids.iter().flat_map(|solid| &solid.groups) {
        if !materials.iter().any(|(name, _)| *name == group.material) {
            materials.push((&group.material, group.colour));
        }
    }
    materials
}

/// The place of a group's material among `materials`.
fn place_of(materials: &[(&str, Colour)], group: &Group) -> usize {
    materials.iter().position(|(name, _)| *name == group.material).unwrap_or_default()
}
