//! Where places are seen from a camera.

use fumetto_scene::Camera;
use glam::{Mat4, Vec3};
use rayon::prelude::*;

/// A place on the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    /// Pixels from the top left.
    pub(crate) x: f32,
    pub(crate) y: f32,
    /// One over the distance along the line of sight: linear on the picture; not above zero behind the near plane.
    pub(crate) near: f32,
}

/// A camera and a picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sight {
    pub(crate) eye: Vec3,
    view_from_world: Mat4,
    pub(crate) focal_px: f32,
    /// Distance of the near plane.
    pub(crate) near_m: f32,
    pub(crate) size_px: [f32; 2],
}

impl Sight {
    pub(crate) fn new(camera: &Camera, size_px: [u32; 2]) -> Self {
        let (eye, target) = (Vec3::from(camera.eye), Vec3::from(camera.target));
        let size_px = size_px.map(|side| side as f32);
        Self {
            eye,
            view_from_world: glam::camera::rh::view::look_at_mat4(eye, target, Vec3::from(camera.up)),
            focal_px: 0.5 * size_px[1] / (0.5 * camera.fov_deg.to_radians()).tan(),
            near_m: camera.near.unwrap_or(0.01 * eye.distance(target)),
            size_px,
        }
    }

    pub(crate) fn spot(&self, place: Vec3) -> Spot {
        self.spot_in_view(self.view_from_world.transform_point3(place))
    }

    fn spot_in_view(&self, place: Vec3) -> Spot {
        let distance = -place.z;
        let near = if distance >= self.near_m { distance.recip() } else { 0.0 };
        let [width, height] = self.size_px;
        let scale = self.focal_px * near;
        Spot { x: 0.5 * width + scale * place.x, y: 0.5 * height - scale * place.y, near }
    }

    pub(crate) fn spots(&self, places: &[Vec3]) -> Vec<Spot> {
        places.par_iter().map(|&place| self.spot(place)).collect()
    }

    /// What of a line lies before the near plane, as shares of the way from its start to its end.
    pub(crate) fn in_front(&self, start: Vec3, end: Vec3) -> Option<[f32; 2]> {
        let depth = |place: Vec3| -self.view_from_world.transform_point3(place).z - self.near_m;
        let (first, last) = (depth(start), depth(end));
        // A little beyond, so that rounding leaves it there.
        let cut = |from: f32, to: f32| (1e-4 * self.near_m - from) / (to - from);
        match (first >= 0.0, last >= 0.0) {
            (true, true) => Some([0.0, 1.0]),
            (true, false) => Some([0.0, 1.0 - cut(last, first)]),
            (false, true) => Some([cut(first, last), 1.0]),
            (false, false) => None,
        }
    }

    /// What of a triangle lies before the near plane: up to two triangles.
    pub(crate) fn cut(&self, corners: [Vec3; 3]) -> Vec<[Spot; 3]> {
        let mut kept: Vec<Vec3> = Vec::with_capacity(4);
        for index in 0..3 {
            let (a, b) = (corners[index], corners[(index + 1) % 3]);
            if let Some([from, to]) = self.in_front(a, b) {
                kept.extend([a.lerp(b, from), a.lerp(b, to)]);
                if to == 1.0 {
                    // The next side begins there.
                    kept.pop();
                }
            }
        }
        let spots: Vec<Spot> = kept.into_iter().map(|place| self.spot(place)).collect();
        (2..spots.len()).map(|last| [spots[0], spots[last - 1], spots[last]]).collect()
    }
}
