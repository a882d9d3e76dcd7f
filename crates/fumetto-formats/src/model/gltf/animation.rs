//! What moves nodes (glTF 2.0, section 3.11).

use std::sync::Arc;

use glam::Vec4;
use gltf_json::accessor::ComponentType::{F32, I8, I16, U8, U16};
use gltf_json::animation::{Channel, Interpolation as JsonInterpolation, Property as JsonProperty, Sampler};
use gltf_json::validation::Checked;
use rustc_hash::{FxHashMap, FxHashSet};

use super::document::{Document, label};
use super::scene::Visit;
use crate::FormatError;
use crate::model::curve::{Curve, Interpolation};
use crate::model::rig::{Node, Pose, Property, Track};
use crate::notes::Notes;

/// What moves the visited nodes, in all animations.
///
/// Where several animations move the same property of a node, as in a file with a walk and a run, the
/// first one counts.
pub(super) fn tracks(
    document: &Document<'_>,
    visits: &[Visit],
    nodes: &[Node],
    notes: &mut Notes,
) -> Result<Vec<Track>, FormatError> {
    let mut reader = Reader { document, times: FxHashMap::default(), values: FxHashMap::default() };
    let places: FxHashMap<usize, usize> =
        visits.iter().enumerate().map(|(place, visit)| (visit.node, place)).collect();
    let mut moved = FxHashSet::default();
    let mut tracks = Vec::new();
    for (number, animation) in document.root.animations.iter().enumerate() {
        let animation_label = label("animation", number, animation.name.as_deref());
        for (channel_number, channel) in animation.channels.iter().enumerate() {
            let element = format!("{animation_label}, channel {channel_number}");
            let Some(property) = property(channel) else {
                notes.say(&animation_label, "it moves more than nodes; only their motion is shown");
                continue;
            };
            let Some(&node) = places.get(&channel.target.node.value()) else { continue };
            if matches!(nodes[node].rest, Pose::Matrix(_)) {
                notes.say(&element, "its node has a matrix, which cannot move");
                continue;
            }
            if !moved.insert((node, property)) {
                notes.say(
                    &animation_label,
                    "another animation moves the same nodes, and only the first one is shown",
                );
                continue;
            }
            let index = channel.sampler.value();
            let sampler =
                animation.samplers.get(index).ok_or_else(|| document.absent(&element, "sampler", index))?;
            let curve = reader.curve(&element, sampler, property)?;
            tracks.push(Track { node, property, curve });
        }
    }
    Ok(tracks)
}

fn property(channel: &Channel) -> Option<Property> {
    match channel.target.path {
        Checked::Valid(JsonProperty::Translation) => Some(Property::Translation),
        Checked::Valid(JsonProperty::Rotation) => Some(Property::Rotation),
        Checked::Valid(JsonProperty::Scale) => Some(Property::Scale),
        _ => None,
    }
}

/// Reads key frames, each accessor once.
struct Reader<'a> {
    document: &'a Document<'a>,
    times: FxHashMap<usize, Arc<[f32]>>,
    values: FxHashMap<(usize, usize), Arc<[Vec4]>>,
}

impl Reader<'_> {
    fn curve(&mut self, element: &str, sampler: &Sampler, property: Property) -> Result<Curve, FormatError> {
        let Checked::Valid(interpolation) = sampler.interpolation else {
            return Err(self
                .document
                .wrong(element, "its interpolation is not known; export the model again"));
        };
        let (interpolation, values_a_key) = match interpolation {
            JsonInterpolation::Step => (Interpolation::Step, 1),
            JsonInterpolation::Linear => (Interpolation::Linear, 1),
            JsonInterpolation::CubicSpline => (Interpolation::CubicSpline, 3),
        };
        let width = if property == Property::Rotation { 4 } else { 3 };
        let times_secs = self.times(element, sampler.input.value())?;
        let values = self.values(element, sampler.output.value(), width)?;
        if values.len() != values_a_key * times_secs.len() {
            let problem = format!(
                "{} key frames need {} values but have {}; export the model again",
                times_secs.len(),
                values_a_key * times_secs.len(),
                values.len()
            );
            return Err(self.document.wrong(element, problem));
        }
        Ok(Curve { times_secs, values, interpolation })
    }

    fn times(&mut self, element: &str, index: usize) -> Result<Arc<[f32]>, FormatError> {
        if let Some(known) = self.times.get(&index) {
            return Ok(known.clone());
        }
        let accessor = self.document.accessor(element, index)?;
        let wrong =
            |problem: &str| self.document.wrong(element, format!("{problem}; export the model again"));
        if !accessor.is(1, &[F32]) || accessor.count == 0 {
            return Err(wrong("it has no times of key frames"));
        }
        self.document.take_items(element, accessor.count)?;
        let times: Arc<[f32]> = (0..accessor.count).map(|i| accessor.vector::<1>(i)[0]).collect();
        // Said so that it does not hold for what is not a number.
        let forwards = times.windows(2).all(|pair| pair[0] < pair[1]);
        if !forwards || !times.iter().all(|time| (0.0..f32::INFINITY).contains(time)) {
            return Err(wrong("the times of its key frames do not run forwards from 0"));
        }
        self.times.insert(index, times.clone());
        Ok(times)
    }

    fn values(&mut self, element: &str, index: usize, width: usize) -> Result<Arc<[Vec4]>, FormatError> {
        if let Some(known) = self.values.get(&(index, width)) {
            return Ok(known.clone());
        }
        let accessor = self.document.accessor(element, index)?;
        if !accessor.is(width, &[F32, I8, U8, I16, U16]) {
            let problem = format!("accessor {index} cannot be what it moves; export the model again");
            return Err(self.document.wrong(element, problem));
        }
        self.document.take_items(element, accessor.count)?;
        let values: Arc<[Vec4]> = (0..accessor.count).map(|i| Vec4::from(accessor.vector::<4>(i))).collect();
        if let Some(wild) = values.iter().position(|value| !value.is_finite()) {
            return Err(self
                .document
                .wrong(element, format!("value {wild} is not finite; export the model again")));
        }
        self.values.insert((index, width), values.clone());
        Ok(values)
    }
}
