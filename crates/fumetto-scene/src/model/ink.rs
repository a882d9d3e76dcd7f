use crate::{Colour, Stroke};

/// Lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Ink {
    /// Whether there are any.
    pub on: bool,
    /// How they are found.
    pub method: InkMethod,
    /// Their colour, where a kind of edge has no other.
    pub colour: Colour,
    /// How wide the outline is.
    pub width: Width,
    /// How far the ink billboard lies behind its particle, in widths of the particle: the larger,
    /// the fewer inner lines (McGuire's *d*).
    pub offset: f32,
    /// Width of inner lines over the outline's, 0 to 1.
    pub inner: f32,
    /// How much thinner lines are where they face the light, 0 to 1.
    pub lit_thinning: f32,
    /// Lines shorter than this many widths are left out.
    pub shortest: f32,
    /// Where the surface turns away from the viewer.
    pub silhouette: Pen,
    /// Where faces meet at an angle.
    pub crease: Pen,
    /// Where the surface ends.
    pub boundary: Pen,
    /// Where two materials meet.
    pub material: Pen,
    /// Faces that turn by more than this make a crease, in degrees.
    pub crease_deg: f32,
    /// For [`InkMethod::Angle`]: the cosine between the surface and the viewer under which there is ink.
    pub facing: f32,
    /// What becomes of lines behind something.
    pub hidden: HiddenLines,
    /// What is drawn along lines, where a kind of edge has no stroke of its own; nothing for plain lines.
    pub stroke: Option<Stroke>,
}

/// How lines are found (Real-Time Rendering, chapter 11).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InkMethod {
    /// Where the surface is seen edge-on.
    Angle,
    /// By a larger copy of the model, of which only the inside is drawn.
    Shell,
    /// Where neighbouring pixels differ in depth, normal or object.
    Image,
    /// Along the model's edges, found anew for every view.
    Vector,
    /// What suits each shape: ink billboards behind puffs, vector edges on meshes, and image edges where
    /// shapes run into each other.
    Hybrid,
}

/// A kind of edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeKind {
    /// Where the surface turns away from the viewer.
    Silhouette,
    /// Where faces meet at an angle.
    Crease,
    /// Where the surface ends.
    Boundary,
    /// Where two materials meet.
    Material,
}

impl EdgeKind {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Silhouette, Self::Crease, Self::Boundary, Self::Material];
}

/// How one kind of edge is drawn, where it differs from [`Ink`].
#[derive(Clone, Debug, PartialEq)]
pub struct Pen {
    /// Whether it is.
    pub on: bool,
    /// Its colour.
    pub colour: Option<Colour>,
    /// Its width.
    pub width: Option<Width>,
    /// Lengths that are drawn and left out in turn, in pixels at [`Style::height_px`](crate::Style::height_px).
    pub dash_px: Option<[f32; 2]>,
    /// What is drawn along it.
    pub stroke: Option<Stroke>,
}

/// What becomes of lines that something hides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HiddenLines {
    /// They are not drawn.
    Gone,
    /// They are dashed, as in technical drawings.
    Dashed,
}

/// Width of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Width {
    /// In pixels at [`Style::height_px`](crate::Style::height_px).
    Px(f32),
    /// In metres.
    World(f32),
}

impl Ink {
    /// The pen of one kind of edge, as the style changes it.
    #[must_use]
    pub fn pen(&self, kind: EdgeKind) -> &Pen {
        match kind {
            EdgeKind::Silhouette => &self.silhouette,
            EdgeKind::Crease => &self.crease,
            EdgeKind::Boundary => &self.boundary,
            EdgeKind::Material => &self.material,
        }
    }

    /// The stroke along one kind of edge, if it has any.
    #[must_use]
    pub fn stroke_of(&self, kind: EdgeKind) -> Option<&Stroke> {
        let pen = self.pen(kind);
        pen.stroke.as_ref().or(self.stroke.as_ref()).filter(|stroke| stroke.on && self.on && pen.on)
    }

    /// The strokes of all kinds of edges that have any.
    pub fn strokes(&self) -> impl Iterator<Item = &Stroke> {
        EdgeKind::ALL.into_iter().filter_map(|kind| self.stroke_of(kind))
    }

    /// Whether any kind of edge has a stroke.
    #[must_use]
    pub fn has_strokes(&self) -> bool {
        self.strokes().next().is_some()
    }

    /// The colour of one kind of edge.
    #[must_use]
    pub fn colour_of(&self, kind: EdgeKind) -> Colour {
        self.pen(kind).colour.unwrap_or(self.colour)
    }

    /// The width of one kind of edge: without one of its own, creases and borders of materials are inner
    /// lines, the others outlines.
    #[must_use]
    pub fn width_of(&self, kind: EdgeKind) -> Width {
        let share = match kind {
            EdgeKind::Silhouette | EdgeKind::Boundary => 1.0,
            EdgeKind::Crease | EdgeKind::Material => self.inner,
        };
        self.pen(kind).width.unwrap_or(match self.width {
            Width::Px(px) => Width::Px(share * px),
            Width::World(metres) => Width::World(share * metres),
        })
    }
}

impl Default for Ink {
    fn default() -> Self {
        let pen = Pen { on: true, colour: None, width: None, dash_px: None, stroke: None };
        Self {
            on: true,
            method: InkMethod::Hybrid,
            colour: Colour::from_srgb8([0; 3]),
            width: Width::Px(2.0),
            offset: 1.0,
            inner: 1.0,
            lit_thinning: 0.0,
            shortest: 0.0,
            silhouette: pen.clone(),
            crease: pen.clone(),
            boundary: pen.clone(),
            material: pen,
            crease_deg: 60.0,
            facing: 0.25,
            hidden: HiddenLines::Gone,
            stroke: None,
        }
    }
}
