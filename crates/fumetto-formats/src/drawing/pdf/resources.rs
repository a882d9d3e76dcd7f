//! What the content of a page or of a group names.

use pdf_writer::{Name, Ref};

#[derive(Default)]
pub(super) struct Resources {
    /// Opacities, with the objects that hold them.
    states: Vec<(f32, Ref)>,
    objects: Vec<Ref>,
    /// That of the paper.
    pub(super) shading: Option<Ref>,
    layers: Vec<Ref>,
}

impl Resources {
    /// The name of an opacity; `make` makes one that is new.
    pub(super) fn state(&mut self, opacity: f32, make: impl FnOnce() -> Ref) -> String {
        let known = self.states.iter().position(|(known, _)| *known == opacity);
        let index = known.unwrap_or_else(|| {
            self.states.push((opacity, make()));
            self.states.len() - 1
        });
        format!("G{index}")
    }

    /// The name of an image or a group.
    pub(super) fn object(&mut self, object: Ref) -> String {
        self.objects.push(object);
        format!("X{}", self.objects.len() - 1)
    }

    /// The name of a layer.
    pub(super) fn layer(&mut self, layer: Ref) -> String {
        self.layers.push(layer);
        format!("L{}", self.layers.len() - 1)
    }

    pub(super) fn write(&self, mut to: pdf_writer::writers::Resources<'_>) {
        list(to.ext_g_states(), 'G', self.states.iter().map(|(_, state)| *state));
        list(to.x_objects(), 'X', self.objects.iter().copied());
        list(to.insert(Name(b"Properties")).dict(), 'L', self.layers.iter().copied());
        if let Some(shading) = self.shading {
            to.shadings().pair(Name(b"Paper"), shading);
        }
    }
}

fn list(mut to: pdf_writer::Dict<'_>, letter: char, references: impl Iterator<Item = Ref>) {
    for (index, reference) in references.enumerate() {
        to.pair(Name(format!("{letter}{index}").as_bytes()), reference);
    }
}
