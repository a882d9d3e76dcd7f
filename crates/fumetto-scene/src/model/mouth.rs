//! What an emitter looks like to the air that streams out of it.

use crate::{Emitter, EmitterShape};

/// Shorter vectors point nowhere: their squares are close to where 32 bits end.
const LEAST_SPEED: f32 = 1e-9;

/// The end of the pipe out of which smoke comes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mouth {
    /// Which way the jet goes, of length 1. Without a velocity: a disc's normal, or up.
    pub axis: [f32; 3],
    /// Radius of what is seen to come out, in metres: the shape's and a puff's.
    pub radius: f32,
    /// Speed along the axis, in m/s: the mean over the cone of directions.
    pub speed: f32,
    /// Speed away from the axis at the cone's edge, in m/s.
    pub outward: f32,
}

impl Emitter {
    /// What its jet is like.
    #[must_use]
    pub fn mouth(&self) -> Mouth {
        let [x, y, z] = self.velocity;
        let speed = (x * x + y * y + z * z).sqrt();
        let axis = if speed > LEAST_SPEED { self.velocity.map(|v| v / speed) } else { self.at_rest() };
        // Directions are spread evenly over a cone: this is the mean of their cosines.
        let along = 0.5 * (1.0 + self.spread_deg.to_radians().cos());
        let young = self.radius_over_life.points.first().map_or(1.0, |point| point[1]);
        let puff = 0.5 * (self.radius[0] + self.radius[1]) * young;
        Mouth {
            axis,
            radius: self.opening(axis) + puff,
            speed: speed * along,
            outward: speed * (1.0 - along * along).max(0.0).sqrt(),
        }
    }

    /// Which way a mouth without a jet looks.
    fn at_rest(&self) -> [f32; 3] {
        match self.shape {
            EmitterShape::Disc { normal: [x, y, z], .. } => {
                let length = (x * x + y * y + z * z).sqrt();
                [x / length, y / length, z / length]
            }
            _ => [0.0, 1.0, 0.0],
        }
    }

    /// Radius of the shape across `axis`; of a box its narrower half, for rings appear anywhere in it.
    fn opening(&self, axis: [f32; 3]) -> f32 {
        match self.shape {
            EmitterShape::Point { .. } | EmitterShape::Line { .. } => 0.0,
            EmitterShape::Disc { radius, .. } | EmitterShape::Sphere { radius, .. } => radius,
            EmitterShape::Box { size, .. } => {
                let steepest = (0..3).max_by(|&a, &b| axis[a].abs().total_cmp(&axis[b].abs()));
                let across = (0..3).filter(|&side| Some(side) != steepest).map(|side| size[side]);
                0.5 * across.fold(f32::INFINITY, f32::min)
            }
        }
    }
}
