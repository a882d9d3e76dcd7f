//! Drawings of closed shapes and lines, for programs in which people go on drawing.

mod names;
mod path_data;
mod pdf;
mod svg;

use kurbo::BezPath;

pub use self::{
    pdf::write_pdf,
    svg::{write_animated_svg, write_svg},
};
use crate::{Image, WriteError};

/// A picture made of shapes, in pixels from its top left corner.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width and height.
    pub size_px: [u32; 2],
    /// Width on paper in millimetres; without it, a pixel is one of CSS: 96 to the inch.
    pub width_mm: Option<f64>,
    /// What lies behind everything.
    pub paper: Paper,
    /// From the bottom to the top.
    pub layers: Vec<Folder>,
}

/// What a drawing is on.
#[derive(Clone, Debug, PartialEq)]
pub enum Paper {
    /// Nothing.
    Clear,
    /// One colour; sRGB.
    Colour([u8; 3]),
    /// Colours at equal distances from the top edge to the bottom edge; sRGB.
    Gradient(Vec<[u8; 3]>),
    /// A picture that is scaled to cover the paper, and centred.
    Image(Image),
}

/// Shapes under one name: a layer, or a group in one.
#[derive(Clone, Debug, PartialEq)]
pub struct Folder {
    /// What people call it. Programs get an id made from it.
    pub name: String,
    /// Whether drawing programs list it among their layers.
    pub is_layer: bool,
    /// Of all of it together, from 0 to 1.
    pub opacity: f32,
    /// From the bottom to the top.
    pub items: Vec<Item>,
}

/// What is in a folder.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// A group, or a layer of a layer.
    Folder(Folder),
    /// Something that is seen.
    Shape(Shape),
}

/// A path and how it is painted.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// What people call it. Programs get an id made from it.
    pub name: String,
    /// Closed, where it is filled: the inside is where its lines go round more often one way than the other.
    pub path: BezPath,
    /// sRGB.
    pub colour: [u8; 3],
    /// From 0 to 1.
    pub opacity: f32,
    /// Width of a line that follows the path, round at its ends and corners; without one, the path is filled.
    pub stroke_px: Option<f64>,
}

impl Drawing {
    /// Pixels to a millimetre.
    fn px_a_mm(&self) -> f64 {
        let width_px = f64::from(self.size_px[0]);
        self.width_mm.map_or(96.0 / 25.4, |width_mm| width_px / width_mm)
    }

    /// How many shapes there are in all folders.
    #[must_use]
    pub fn shape_count(&self) -> usize {
        self.layers.iter().map(Folder::shape_count).sum()
    }

    /// How many straight and curved pieces their paths have.
    #[must_use]
    pub fn segment_count(&self) -> usize {
        self.layers.iter().map(Folder::segment_count).sum()
    }

    /// Refuses what no program could show.
    fn check(&self) -> Result<(), WriteError> {
        let refused = |problem| Err(WriteError::Drawing { problem });
        if self.size_px.contains(&0) {
            return refused("it has no size");
        }
        if self.width_mm.is_some_and(|width| !(width > 0.0 && width.is_finite())) {
            return refused("its width in millimetres is not above zero");
        }
        if !self.layers.iter().all(|layer| layer.shapes().all(|shape| shape.path.is_finite())) {
            return refused(
                "a path of it leads nowhere; look at the `transform`s of objects, and at their models",
            );
        }
        Ok(())
    }
}

impl Folder {
    /// An empty, opaque layer.
    #[must_use]
    pub fn layer(name: impl Into<String>) -> Self {
        Self { name: name.into(), is_layer: true, opacity: 1.0, items: Vec::new() }
    }

    /// An empty, opaque group.
    #[must_use]
    pub fn group(name: impl Into<String>) -> Self {
        Self { is_layer: false, ..Self::layer(name) }
    }

    /// All shapes in it, from the bottom to the top.
    pub fn shapes(&self) -> Box<dyn Iterator<Item = &Shape> + '_> {
        Box::new(self.items.iter().flat_map(|item| match item {
            Item::Folder(folder) => folder.shapes(),
            Item::Shape(shape) => Box::new(std::iter::once(shape)),
        }))
    }

    fn shape_count(&self) -> usize {
        self.shapes().count()
    }

    fn segment_count(&self) -> usize {
        self.shapes().map(|shape| shape.path.segments().count()).sum()
    }
}
