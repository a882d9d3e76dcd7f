use crate::{Detail, Imported, Ink, Mesh, Metamorphosis, Paint, Particle, Shape, Smoke, Style};

/// A thing in the scene: matter, its shape, and how it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Unique in the scene.
    pub name: String,
    /// Whether it is drawn.
    pub visible: bool,
    /// What it is made of.
    pub matter: Matter,
    /// How its particles get a shape.
    pub shape: Shape,
    /// Surfaces inside its own.
    pub details: Vec<Detail>,
    /// How it is drawn: the scene's style with the object's changes.
    pub style: Style,
    /// Flat transparency of the whole object, from 0 to 1 (opaque).
    pub opacity: f32,
}

impl Object {
    /// How its lines are drawn, then those of the surfaces inside it.
    pub fn inks(&self) -> impl Iterator<Item = &Ink> {
        std::iter::once(&self.style.ink).chain(self.details.iter().map(|detail| &detail.ink))
    }
}

/// What an object is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Matter {
    /// Particles that the scene lists.
    Still(Vec<Particle>),
    /// Particles in a PLY or CSV file; `####` or `{}` in the path numbers a sequence by frame.
    File(String),
    /// Particles that become others.
    Morph(Metamorphosis),
    /// Particles that emitters make and forces move.
    Smoke(Smoke),
    /// Triangles of a model.
    Mesh(Mesh),
    /// A volume in a file.
    Imported(Box<Imported>),
    /// Volumes that change how all else is drawn.
    Paint(Paint),
}
