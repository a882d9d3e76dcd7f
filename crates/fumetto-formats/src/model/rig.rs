//! The nodes that place a model's parts, and how they move.

use std::ops::Range;

use glam::{Mat4, Quat, Vec3};

use super::Placed;
use super::curve::Curve;

/// Nodes in trees, with what moves them.
#[derive(Clone, Debug, Default)]
pub(super) struct Rig {
    /// Every node comes after its parent, so that one pass from front to back places them all.
    pub(super) nodes: Vec<Node>,
    pub(super) tracks: Vec<Track>,
}

/// A coordinate system that may hold parts.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) parent: Option<usize>,
    pub(super) rest: Pose,
    /// The parts at this node.
    pub(super) parts: Range<usize>,
    /// Where copies of the parts stand in it, if it is not they themselves.
    pub(super) instances: Option<Vec<Mat4>>,
}

/// How a node stands in its parent.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pose {
    /// Any transform; such nodes do not move.
    Matrix(Mat4),
    /// Scaled, then turned, then moved.
    Parts { translation: Vec3, rotation: Quat, scale: Vec3 },
}

/// What moves one property of one node.
#[derive(Clone, Debug)]
pub(super) struct Track {
    pub(super) node: usize,
    pub(super) property: Property,
    pub(super) curve: Curve,
}

/// What of a node moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Property {
    Translation,
    Rotation,
    Scale,
}

impl Rig {
    /// All of `parts` where they are.
    pub(super) fn still(parts: Range<usize>) -> Self {
        let node = Node { parent: None, rest: Pose::Matrix(Mat4::IDENTITY), parts, instances: None };
        Self { nodes: vec![node], tracks: Vec::new() }
    }

    pub(super) fn is_animated(&self) -> bool {
        !self.tracks.is_empty()
    }

    pub(super) fn duration_secs(&self) -> f32 {
        let ends = self.tracks.iter().filter_map(|track| track.curve.times_secs.last());
        ends.copied().fold(0.0, f32::max)
    }

    /// The sum of `of` over all placed parts.
    pub(super) fn count(&self, of: impl Fn(usize) -> u64) -> u64 {
        let here = |node: &Node| node.copies() as u64 * node.parts.clone().map(&of).sum::<u64>();
        self.nodes.iter().map(here).sum()
    }

    pub(super) fn placed(&self, time_secs: f32) -> Vec<Placed> {
        let mut world_from_node: Vec<Mat4> = Vec::with_capacity(self.nodes.len());
        let poses = self.poses(time_secs);
        let (mut placed, mut group) = (Vec::new(), 0);
        for (node, pose) in self.nodes.iter().zip(poses) {
            let parent = node.parent.map_or(Mat4::IDENTITY, |parent| world_from_node[parent]);
            let here = parent * pose.matrix();
            world_from_node.push(here);
            let itself = [Mat4::IDENTITY];
            for &copy in node.instances.as_deref().unwrap_or(&itself) {
                let world_from_part = finite(here * copy).to_cols_array_2d();
                placed.extend(node.parts.clone().map(|part| Placed { part, group, world_from_part }));
                group += 1;
            }
        }
        placed
    }

    /// How every node stands at a time.
    fn poses(&self, time_secs: f32) -> Vec<Pose> {
        let mut poses: Vec<Pose> = self.nodes.iter().map(|node| node.rest).collect();
        let time_secs = self.looped(time_secs);
        for track in &self.tracks {
            if let Pose::Parts { translation, rotation, scale } = &mut poses[track.node] {
                match track.property {
                    Property::Translation => *translation = track.curve.at(time_secs).truncate(),
                    Property::Rotation => *rotation = track.curve.rotation_at(time_secs),
                    Property::Scale => *scale = track.curve.at(time_secs).truncate(),
                }
            }
        }
        poses
    }

    /// The time within the animations that `time_secs` shows.
    fn looped(&self, time_secs: f32) -> f32 {
        let looped = time_secs.rem_euclid(self.duration_secs());
        // Nothing is left of a division by no duration, nor of an endless time.
        if looped.is_finite() { looped } else { 0.0 }
    }
}

impl Node {
    /// How many of its parts there are.
    pub(super) fn copies(&self) -> usize {
        self.instances.as_ref().map_or(1, Vec::len)
    }
}

impl Pose {
    fn matrix(self) -> Mat4 {
        match self {
            Self::Matrix(matrix) => matrix,
            Self::Parts { translation, rotation, scale } => {
                Mat4::from_scale_rotation_translation(scale, rotation, translation)
            }
        }
    }
}

/// Flattens to nothing what has grown beyond all numbers.
fn finite(matrix: Mat4) -> Mat4 {
    if matrix.is_finite() { matrix } else { Mat4::from_scale(Vec3::ZERO) }
}
