//! What a ball covers, computed beside the engine: the nailboard of one ball, pixel by pixel.

use glam::{Vec2, Vec3};

use crate::stage::{CORE, DISTANCE, PX_PER_METRE, SIDE};

/// Where the camera of every stage stands.
pub(crate) const EYE: Vec3 = Vec3::new(0.0, 0.0, DISTANCE);

/// The ray through the middle of a pixel, one metre deep.
pub(crate) fn ray(x: u32, y: u32) -> Vec3 {
    let px = Vec2::new(x as f32, y as f32) + 0.5 - 0.5 * SIDE as f32;
    Vec3::new(px.x, -px.y, -PX_PER_METRE * DISTANCE) / (PX_PER_METRE * DISTANCE)
}

/// How far along `ray` a puff of one ball is met: its picture is that of the ball from straight before
/// it, scaled by the distance of its middle.
pub(crate) fn distance(ray: Vec3, [x, y, z, radius]: [f32; 4]) -> Option<f32> {
    let middle = Vec3::new(x, y, z) - EYE;
    let depth = -middle.z;
    let offset = (ray.truncate() * depth - middle.truncate()) / radius;
    let height = (CORE * CORE - offset.length_squared()).max(0.0).sqrt();
    (height > 0.0).then_some(depth - height * radius)
}
