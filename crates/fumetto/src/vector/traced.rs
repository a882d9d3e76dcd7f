//! Filled shapes of a picture's samples.

use kurbo::BezPath;

use super::{
    borders::Borders,
    fills::{Map, Turn},
    regions::{Labels, Regions},
    smooth::{Hand, curves},
};

/// The paths that are filled for each label, by number; `per_px` samples make a pixel across and down. Regions of
/// less than `least_px` square pixels have joined others.
pub(super) fn traced(
    labels: Labels,
    turns: &[Turn],
    per_px: [f64; 2],
    (least_px, hand): (f64, Hand),
) -> Vec<BezPath> {
    let least = (least_px * per_px[0] * per_px[1]).round() as usize;
    let regions = Regions::new(labels, least);
    let borders = Borders::new(&regions);
    let curves = curves(&borders, per_px, hand);
    let map = Map { regions: &regions, borders: &borders, curves: &curves, turns };
    (0..turns.len() as u16).map(|label| map.fill(label)).collect()
}
