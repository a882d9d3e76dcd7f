//! Layers of detail: surfaces inside others, of which only lines are drawn (Álvarez et al. 2007, section 5).
//!
//! Each counts as an object with a number after those of the scene, so that it has a style and pens of its
//! own. The first layers of all objects are level 0, the second ones level 1: those of one level are drawn
//! together, so that they hide each other's lines and their own.

use std::ops::Range;

use fumetto_scene::{Detail, Matter, Object, Scene, Shape};

/// All layers of detail of a scene.
#[derive(Debug)]
pub(crate) struct Details {
    layers: Vec<Layer>,
    /// As objects without matter of their own.
    objects: Vec<Object>,
    /// Number of the first.
    first: usize,
}

/// One of them.
#[derive(Clone, Debug)]
pub(crate) struct Layer {
    /// Number of the object that it is in.
    pub(crate) object: usize,
    level: usize,
    pub(crate) detail: Detail,
}

impl Details {
    pub(crate) fn new(scene: &Scene) -> Self {
        let layers: Vec<_> = (0..)
            .zip(&scene.objects)
            .flat_map(|(object, outer)| {
                let details = outer.details.iter().enumerate();
                details.map(move |(level, detail)| Layer { object, level, detail: detail.clone() })
            })
            .collect();
        let objects = layers.iter().map(|layer| inner(&scene.objects[layer.object], &layer.detail));
        Self { objects: objects.collect(), layers, first: scene.objects.len() }
    }

    /// In the order of their numbers.
    pub(crate) fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// Likewise, as objects.
    pub(crate) fn objects(&self) -> &[Object] {
        &self.objects
    }

    /// All levels that any of the objects has which `members` numbers.
    pub(crate) fn levels(&self, members: &[usize]) -> Range<usize> {
        let levels = self.layers.iter().filter(|layer| members.contains(&layer.object));
        0..levels.map(|layer| layer.level + 1).max().unwrap_or(0)
    }

    /// Numbers of the layers of one level in the objects that `members` numbers.
    pub(crate) fn members(&self, members: &[usize], level: usize) -> Vec<usize> {
        let numbered = (self.first..).zip(&self.layers);
        numbered
            .filter(|(_, layer)| layer.level == level && members.contains(&layer.object))
            .map(|(number, _)| number)
            .collect()
    }

    /// `members`, and the numbers of all layers in them.
    pub(crate) fn with(&self, members: &[usize]) -> Vec<usize> {
        let inside = self.levels(members).flat_map(|level| self.members(members, level));
        members.iter().copied().chain(inside).collect()
    }
}

/// A layer of detail in `outer` as an object.
fn inner(outer: &Object, detail: &Detail) -> Object {
    let mut style = outer.style.clone();
    style.ink = detail.ink.clone();
    Object {
        name: outer.name.clone(),
        visible: outer.visible,
        matter: Matter::Still(Vec::new()),
        shape: Shape::Surface(detail.surface),
        details: Vec::new(),
        style,
        opacity: outer.opacity,
    }
}
