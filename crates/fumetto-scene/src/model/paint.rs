use crate::{Colour, Matter, Scene, Stain, Style, Width};

/// Paint that spreads over what the scene shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Paint {
    /// Drops, in the order of the file.
    pub drops: Vec<Drop>,
    /// Strokes of a brush, likewise.
    pub strokes: Vec<Brush>,
    /// What holds paint that is poured.
    pub cells: Option<Cells>,
    /// Paint that is poured into these; none without them.
    pub pours: Vec<Pour>,
    /// What particles leave on models.
    pub stains: Vec<Stain>,
    /// How it moves.
    pub spread: Spread,
    /// Where it stays: the middle and the sides of a box.
    pub keep: Option<[[f32; 3]; 2]>,
    /// What it lays over what it covers.
    pub wash: Option<Wash>,
    /// The line along its edge.
    pub border: Option<Border>,
    /// How it draws what it covers.
    pub inside: Look,
    /// How what no paint covers is drawn, where this paint says so.
    pub outside: Option<Look>,
}

/// A drop of paint.
#[derive(Clone, Debug, PartialEq)]
pub struct Drop {
    /// Where it falls, in metres.
    pub at: [f32; 3],
    /// When it falls.
    pub time_secs: f32,
    /// The radius that pressure drives it to.
    pub radius: Growth,
    /// The radius with which it falls, in metres.
    pub start_m: f32,
}

/// A brush that paints along a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Brush {
    /// Two places or more, in metres.
    pub path: Vec<[f32; 3]>,
    /// From when until when.
    pub during_secs: [f32; 2],
    /// The radius that pressure drives each piece to, from when the brush comes to it.
    pub radius: Growth,
    /// The radius that it begins with, in metres.
    pub start_m: f32,
}

/// A radius over time, linear between its points; before the first and after the last it stays.
#[derive(Clone, Debug, PartialEq)]
pub struct Growth {
    /// `[seconds, metres]`: at least one, with rising seconds.
    pub points: Vec<[f32; 2]>,
}

/// A grid of square cells over the scene's models.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cells {
    /// The middle of the box that it fills, in metres.
    pub center: [f32; 3],
    /// The box's sides, in metres.
    pub size: [f32; 3],
    /// Side of a cell.
    pub cell_m: f32,
    /// How deep paint lies in a cell before it spills.
    pub depth_m: f32,
    /// How fast it runs from cell to cell.
    pub speed_m_per_s: f32,
    /// How unevenly cells hold it, from 0 to 1.
    pub uneven: f32,
}

/// Paint that is poured into cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pour {
    /// Where it falls, in metres.
    pub at: [f32; 3],
    /// From when until when.
    pub during_secs: [f32; 2],
    /// Cubic metres a second.
    pub rate_m3_per_s: f32,
}

/// How paint moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Pieces along each edge of the icosahedron that volumes are made of.
    pub subdivisions: u32,
    /// Pressure over the distance from the desired radius, per square second.
    pub stiffness: f32,
    /// Elasticity over the distance from the radius at first, per square second.
    pub elasticity: f32,
    /// As a share of what is critical.
    pub friction: f32,
    /// In m/s².
    pub gravity: [f32; 3],
    /// Down along the surface of models, in m/s² where it stands upright.
    pub downhill: f32,
    /// How far grain moves the border, as a share of the radius.
    pub grain: f32,
    /// Size of its largest bumps, in metres.
    pub grain_m: f32,
}

/// Volumes in volumes, each of which lays on more paint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wash {
    /// How many.
    pub steps: u32,
    /// How much smaller each is than the one around it, as a share of the radius.
    pub spacing: f32,
    /// The paint's.
    pub colour: Colour,
    /// How much each lays on, from 0 to 1.
    pub strength: f32,
    /// Whether it hides what lies under it, and does not tint it.
    pub covers: bool,
}

/// A line along the edge of paint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Border {
    /// Its colour.
    pub colour: Colour,
    /// Its width.
    pub width: Width,
}

/// How a region is drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Look {
    /// Every object as its style says.
    Own,
    /// The same in shades of grey.
    Monochrome,
    /// Every object in a style of its own here, in their order.
    Styled(Vec<Style>),
}

impl Growth {
    /// The radius `secs` after the beginning, in metres.
    #[must_use]
    pub fn at(&self, secs: f32) -> f32 {
        let after = self.points.partition_point(|point| point[0] <= secs);
        match (after.checked_sub(1).and_then(|i| self.points.get(i)), self.points.get(after)) {
            (Some(&[from, a]), Some(&[until, b])) => a + (b - a) * (secs - from) / (until - from),
            (Some(&[_, radius]), None) | (None, Some(&[_, radius])) => radius,
            (None, None) => 0.0,
        }
    }

    /// The largest of all, in metres.
    #[must_use]
    pub fn largest(&self) -> f32 {
        self.points.iter().map(|point| point[1]).fold(0.0, f32::max)
    }
}

impl Spread {
    /// Pressure and elasticity together: the square of the frequency with which a vertex would ring, per square
    /// second.
    #[must_use]
    pub fn frequency_squared(&self) -> f32 {
        self.stiffness + self.elasticity
    }

    /// What takes speed away, per second: critical friction is twice the frequency.
    #[must_use]
    pub fn damping_per_s(&self) -> f32 {
        2.0 * self.friction * self.frequency_squared().sqrt()
    }

    /// Into how many parts a step of `step_secs` is cut, so that Euler's method neither explodes nor overshoots:
    /// in each, friction takes at most half of the speed, and a vertex goes a quarter of a radian of its ringing.
    #[must_use]
    pub fn substeps(&self, step_secs: f64) -> u32 {
        let frequency = f64::from(self.frequency_squared()).sqrt();
        let fastest = (4.0 * frequency).max(2.0 * f64::from(self.damping_per_s()));
        (fastest * step_secs).ceil().max(1.0) as u32
    }

    /// Vertices of a volume.
    #[must_use]
    pub fn vertices(&self) -> u32 {
        10 * self.subdivisions * self.subdivisions + 2
    }
}

impl Cells {
    /// How many there are along x and z.
    #[must_use]
    pub fn count(&self) -> [u32; 2] {
        [0, 2].map(|axis| (self.size[axis] / self.cell_m).ceil().max(1.0) as u32)
    }
}

impl Paint {
    /// Volumes one in the other, of each drop and stroke.
    #[must_use]
    pub fn layers(&self) -> u32 {
        self.wash.map_or(1, |wash| wash.steps)
    }

    /// How large the `layer`-th of these is over the first.
    #[must_use]
    pub fn wash_scale(&self, layer: u32) -> f32 {
        1.0 - self.wash.map_or(0.0, |wash| wash.spacing) * layer as f32
    }

    /// The largest radius of its drops and strokes, in metres; 0 without any.
    #[must_use]
    pub fn largest_m(&self) -> f32 {
        let drops = self.drops.iter().map(|drop| &drop.radius);
        let radii = drops.chain(self.strokes.iter().map(|stroke| &stroke.radius));
        radii.map(Growth::largest).fold(0.0, f32::max)
    }

    /// How many volumes there may be at once.
    #[must_use]
    pub fn volumes(&self) -> u64 {
        let pieces = self.strokes.iter().map(|stroke| stroke.path.len().saturating_sub(1)).sum::<usize>();
        let cells = self.cells.map_or(0, |cells| cells.count().map(u64::from).iter().product());
        let stains = self.stains.iter().map(Stain::volumes).fold(cells, u64::saturating_add);
        ((self.drops.len() + pieces) as u64).saturating_add(stains).saturating_mul(self.layers().into())
    }

    /// Vertices of all of them.
    #[must_use]
    pub fn vertices(&self) -> u64 {
        self.volumes().saturating_mul(self.spread.vertices().into())
    }

    /// Bytes that these take on the GPU: a radius and its speed for each vertex, and what is known of each
    /// volume.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.vertices().saturating_mul(8).saturating_add(self.volumes().saturating_mul(VOLUME_BYTES))
    }
}

/// Bytes that are kept for a volume beside its vertices: its shape, what it is to do, and the cell that it is.
const VOLUME_BYTES: u64 = 64 + 48 + 32;

impl Scene {
    /// All visible paints, in their order, with the numbers of their objects.
    pub fn paints(&self) -> impl Iterator<Item = (usize, &Paint)> {
        self.objects.iter().enumerate().filter(|(_, object)| object.visible).filter_map(|(index, object)| {
            match &object.matter {
                Matter::Paint(paint) => Some((index, paint)),
                _ => None,
            }
        })
    }

    /// What visible paints draw in styles of its own: the styles of all objects, for what lies inside the first
    /// paint, outside of it, inside the second, and so on.
    pub fn styled_looks(&self) -> impl Iterator<Item = &[Style]> {
        self.paints()
            .flat_map(|(_, paint)| [Some(&paint.inside), paint.outside.as_ref()])
            .flatten()
            .filter_map(Look::styles)
    }

    /// All styles in which an object may be drawn: its own, and those of looks.
    pub fn styles_of(&self, object: usize) -> impl Iterator<Item = &Style> {
        let own = self.objects.get(object).map(|object| &object.style);
        own.into_iter().chain(self.styled_looks().filter_map(move |styles| styles.get(object)))
    }
}

impl Look {
    /// The styles of all objects, where it has any.
    #[must_use]
    pub fn styles(&self) -> Option<&[Style]> {
        match self {
            Self::Styled(styles) => Some(styles),
            Self::Own | Self::Monochrome => None,
        }
    }
}
