//! The shapes of a moment in layers and groups, by the names that people gave.

use fumetto_formats::{Drawing, Folder, Item, Paper, Shape};
use fumetto_scene::{EdgeKind, Object};
use kurbo::BezPath;

use super::{
    DrawingOptions,
    inked::{inked, turns},
    regions::Labels,
    seen::{Owners, Tones},
    smooth::Hand,
    thin::middles,
    traced::traced,
};
use crate::{Player, frame::Plate};

/// Tones of fewer square pixels, in a picture of [`HEIGHT_PX`], join their surroundings: a hand would not draw them.
const LEAST_TONE_PX: f64 = 2.0;

/// Likewise pieces of lines.
const LEAST_INK_PX: f64 = 4.0;

/// Height of a picture for which these are meant, as lengths of styles are.
const HEIGHT_PX: f64 = 720.0;

/// One line or part of one: whose, of which kind, how opaque, and where.
pub(super) struct Stroke {
    /// Among the objects that are drawn, layers of detail included.
    pub(super) object: usize,
    pub(super) kind: EdgeKind,
    pub(super) opacity: f32,
    pub(super) path: BezPath,
    /// Width of a line that follows the path; without one, the path is filled.
    pub(super) stroke_px: Option<f64>,
}

/// Each plate comes with the lines of its models and surfaces.
pub(super) fn drawing<'a>(
    player: &Player,
    size_px: [u32; 2],
    plates: impl Iterator<Item = (&'a Plate, Vec<Stroke>)>,
    paper: Paper,
    options: &DrawingOptions,
) -> Drawing {
    let mut layers = Vec::new();
    for (index, (plate, strokes)) in plates.enumerate() {
        let cel = Cel { player, plate, size_px, options };
        let (tones, opacity) = cel.tones();
        let lines = cel.lines(strokes, opacity);
        let made = [tones, lines].into_iter().filter(|layer| !layer.items.is_empty());
        if index == 0 {
            layers.extend(made);
        } else {
            let mut layer = Folder::layer(cel.name());
            layer.opacity = opacity;
            layer.items.extend(made.map(Item::Folder));
            layers.extend((!layer.items.is_empty()).then_some(layer));
        }
    }
    Drawing { size_px, width_mm: options.width_mm, paper, layers }
}

/// What is drawn together.
struct Cel<'a> {
    player: &'a Player,
    plate: &'a Plate,
    size_px: [u32; 2],
    options: &'a DrawingOptions,
}

impl Cel<'_> {
    fn name(&self) -> String {
        let objects = &self.player.scene().objects;
        self.plate.members.first().map_or(String::new(), |&member| objects[member].name.clone())
    }

    fn is_wanted(&self, object: usize) -> bool {
        self.options.objects.is_empty() || self.options.objects.contains(&object)
    }

    fn per_px(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.plate.size[axis] as f64 / f64::from(self.size_px[axis]))
    }

    /// An area as it is in this picture.
    fn scaled(&self, area_px: f64) -> f64 {
        area_px * (f64::from(self.size_px[1]) / HEIGHT_PX).powi(2)
    }

    /// The layer of flat tones, and the opacity of what is opaque in the cel.
    fn tones(&self) -> (Folder, f32) {
        let mut layer = Folder::layer("tones");
        let Tones { labels, list, turns, opacity } = Tones::of(self.plate, &Owners::new(self.player));
        let whole = f32::from(opacity) / 255.0;
        if self.options.plotter {
            return (layer, whole);
        }
        let paths = traced(labels, &turns, self.per_px(), (self.scaled(LEAST_TONE_PX), Hand::TONES));
        for (tones, paths) in list.chunk_by(|a, b| a.object == b.object).zip(grouped(&list, paths)) {
            let object = tones[0].object;
            if !self.is_wanted(object) {
                continue;
            }
            let mut group = Folder::group(&self.player.scene().objects[object].name);
            for (tone, path) in tones.iter().zip(paths).filter(|(_, path)| !path.elements().is_empty()) {
                let [r, g, b, alpha] = tone.rgba;
                let colour = [r, g, b];
                group.items.push(Item::Shape(Shape {
                    name: format!("tone {r:02x}{g:02x}{b:02x}"),
                    path,
                    colour,
                    opacity: f32::from(alpha) / f32::from(opacity.max(1)),
                    stroke_px: None,
                }));
            }
            layer.items.extend((!group.items.is_empty()).then_some(Item::Folder(group)));
        }
        (layer, whole)
    }

    /// The layer of lines: `strokes`, and those that are traced. `opacity` is that of the cel.
    fn lines(&self, mut strokes: Vec<Stroke>, opacity: f32) -> Folder {
        let drawn = self.player.drawn();
        strokes.extend(self.traced_lines());
        strokes.retain(|stroke| self.is_wanted(self.outer(stroke.object)));
        // Silhouettes lie over all others, those of objects in their order.
        let rank = |kind: EdgeKind| EdgeKind::ALL.iter().rev().position(|&known| known == kind);
        strokes.sort_by_key(|stroke| (stroke.object, rank(stroke.kind)));
        let mut layer = Folder::layer("lines");
        let mut strokes = strokes.into_iter().peekable();
        while let Some(first) = strokes.peek() {
            let number = first.object;
            let object: &Object = drawn[number];
            let strokes = std::iter::from_fn(|| strokes.next_if(|stroke| stroke.object == number));
            let mut group = Folder::group(&object.name);
            group.items.extend(strokes.map(|stroke| Item::Shape(line_shape(object, stroke, opacity))));
            layer.items.push(Item::Folder(group));
        }
        layer
    }

    /// The scene's object that a drawn one is in.
    fn outer(&self, object: usize) -> usize {
        let inner = object.checked_sub(self.player.scene().objects.len());
        inner.map_or(object, |inner| self.player.details.layers()[inner].object)
    }

    /// Lines that are found in the picture.
    fn traced_lines(&self) -> Vec<Stroke> {
        let (labels, marks) = inked(self.plate);
        let stroke = |([pen, opacity], (path, stroke_px)): (&[u8; 2], (BezPath, Option<f64>))| Stroke {
            object: usize::from(*pen) / EdgeKind::ALL.len(),
            kind: EdgeKind::ALL[usize::from(*pen) % EdgeKind::ALL.len()],
            opacity: f32::from(*opacity) / 255.0,
            path,
            stroke_px,
        };
        let paths: Vec<_> = if self.options.plotter {
            (1..=marks.len() as u16).map(|label| self.middles(&labels, label)).collect()
        } else {
            let paths = traced(labels, &turns(&marks), self.per_px(), (self.scaled(LEAST_INK_PX), Hand::INK));
            paths.into_iter().skip(1).map(|path| (path, None)).collect()
        };
        let strokes = marks.iter().zip(paths).map(stroke);
        strokes.filter(|stroke| !stroke.path.elements().is_empty()).collect()
    }

    /// The middles of lines with a label, and how wide these are.
    fn middles(&self, labels: &Labels, label: u16) -> (BezPath, Option<f64>) {
        let [across, down] = self.per_px();
        let (curves, width) = middles(labels.size, |sample| labels.of[sample] == label);
        let mut path = BezPath::new();
        for curve in curves {
            path.extend(BezPath::from_path_segments(curve.into_iter()));
        }
        path.apply_affine(kurbo::Affine::scale_non_uniform(1.0 / across, 1.0 / down));
        (path, Some(width / across))
    }
}

/// The paths of labels from 1 on, by objects.
fn grouped(list: &[super::seen::Tone], paths: Vec<BezPath>) -> Vec<Vec<BezPath>> {
    let mut paths = paths.into_iter().skip(1);
    let groups = list.chunk_by(|a, b| a.object == b.object);
    groups.map(|group| paths.by_ref().take(group.len()).collect()).collect()
}

/// A line as a shape of a cel that is as opaque as `opacity`.
pub(super) fn line_shape(object: &Object, stroke: Stroke, opacity: f32) -> Shape {
    Shape {
        name: kind_name(stroke.kind).to_owned(),
        path: stroke.path,
        colour: object.style.ink.colour_of(stroke.kind).to_srgb8(),
        opacity: (object.opacity * stroke.opacity / opacity.max(1.0 / 255.0)).min(1.0),
        stroke_px: stroke.stroke_px,
    }
}

fn kind_name(kind: EdgeKind) -> &'static str {
    match kind {
        EdgeKind::Silhouette => "silhouette",
        EdgeKind::Crease => "crease",
        EdgeKind::Boundary => "boundary",
        EdgeKind::Material => "material",
    }
}
