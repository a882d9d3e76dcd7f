use fumetto_scene::Camera;
use glam::Vec3;

/// Nearer to straight up or down than this, in degrees, the camera would not know its sides.
const POLE_DEG: f32 = 0.5;

/// Nearest and farthest that the camera goes to what it looks at, in metres.
const DISTANCES: [f32; 2] = [1e-3, 1e6];

/// A direction to look from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Front,
    Back,
    Left,
    Right,
    Top,
    Bottom,
}

impl Side {
    /// From what is looked at to the camera.
    fn direction(self) -> Vec3 {
        match self {
            Self::Front => Vec3::Z,
            Self::Back => Vec3::NEG_Z,
            Self::Left => Vec3::NEG_X,
            Self::Right => Vec3::X,
            Self::Top => Vec3::Y,
            Self::Bottom => Vec3::NEG_Y,
        }
    }
}

/// Moves a camera about what it looks at, as a hand does.
pub(crate) struct Orbit<'a>(pub(crate) &'a mut Camera);

impl Orbit<'_> {
    /// Turns round the target: `right` and `up` in degrees that the scene seems to turn.
    pub(crate) fn turn(&mut self, right_deg: f32, up_deg: f32) {
        let offset = self.offset();
        let distance = offset.length();
        let (x, y, z) = (offset / distance).into();
        let yaw = x.atan2(z) - right_deg.to_radians();
        let limit = (90.0 - POLE_DEG).to_radians();
        let pitch = (y.clamp(-1.0, 1.0).asin() + up_deg.to_radians()).clamp(-limit, limit);
        let direction = Vec3::new(yaw.sin() * pitch.cos(), pitch.sin(), yaw.cos() * pitch.cos());
        self.0.up = [0.0, 1.0, 0.0];
        self.stand(direction, distance);
    }

    /// Moves sideways, so that what is looked at follows a pointer that moved by `right` and `down`, in heights of
    /// the picture.
    pub(crate) fn pan(&mut self, right: f32, down: f32) {
        let forward = -self.direction();
        let side = forward.cross(Vec3::from(self.0.up)).normalize_or(Vec3::X);
        let upward = side.cross(forward);
        let height = 2.0 * self.offset().length() * (0.5 * self.0.fov_deg).to_radians().tan();
        let way = height * (down * upward - right * side);
        self.0.eye = (Vec3::from(self.0.eye) + way).into();
        self.0.target = (Vec3::from(self.0.target) + way).into();
    }

    /// Goes nearer (`share` below 1) or farther away.
    pub(crate) fn dolly(&mut self, share: f32) {
        self.stand(self.direction(), self.offset().length() * share);
    }

    /// Looks from a side, as far away as before.
    pub(crate) fn look_from(&mut self, side: Side) {
        let distance = self.offset().length();
        self.0.up = match side {
            Side::Top => [0.0, 0.0, -1.0],
            Side::Bottom => [0.0, 0.0, 1.0],
            _ => [0.0, 1.0, 0.0],
        };
        self.stand(side.direction(), distance);
    }

    /// Goes to where a ball fills the picture, `aspect` times as wide as high.
    pub(crate) fn frame(&mut self, centre: Vec3, radius: f32, aspect: f32) {
        let half_height = (0.5 * self.0.fov_deg).to_radians();
        let half = half_height.min((half_height.tan() * aspect).atan());
        let direction = self.direction();
        self.0.target = centre.into();
        self.stand(direction, radius.max(DISTANCES[0]) / half.sin());
    }

    fn offset(&self) -> Vec3 {
        let offset = Vec3::from(self.0.eye) - Vec3::from(self.0.target);
        if offset.length_squared() > 0.0 { offset } else { Vec3::Z }
    }

    /// From what is looked at to the camera.
    fn direction(&self) -> Vec3 {
        self.offset().normalize_or(Vec3::Z)
    }

    fn stand(&mut self, direction: Vec3, distance: f32) {
        let distance = distance.clamp(DISTANCES[0], DISTANCES[1]);
        self.0.eye = (Vec3::from(self.0.target) + distance * direction).into();
    }
}

/// The axes of a camera's picture: right, up and toward whoever looks.
pub(crate) fn axes(camera: &Camera) -> [Vec3; 3] {
    let back = (Vec3::from(camera.eye) - Vec3::from(camera.target)).normalize_or(Vec3::Z);
    let right = Vec3::from(camera.up).cross(back).normalize_or(back.any_orthonormal_vector());
    [right, back.cross(right), back]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        Camera {
            name: "view".into(),
            eye: [0.0, 0.0, 4.0],
            target: [0.0, 0.0, 0.0],
            up: [0.0, 1.0, 0.0],
            fov_deg: 40.0,
            near: None,
        }
    }

    fn near(a: [f32; 3], b: [f32; 3]) -> bool {
        Vec3::from(a).distance(b.into()) < 1e-4
    }

    #[test]
    fn a_quarter_turn_looks_from_the_side() {
        let mut camera = camera();
        Orbit(&mut camera).turn(90.0, 0.0);
        assert!(near(camera.eye, [-4.0, 0.0, 0.0]), "{:?}", camera.eye);
        Orbit(&mut camera).turn(-90.0, 500.0);
        assert!(camera.eye[1] < 4.0 && camera.eye[1] > 3.9, "the pole is not passed: {:?}", camera.eye);
    }

    #[test]
    fn panning_by_the_pictures_height_moves_by_it() {
        let mut camera = camera();
        Orbit(&mut camera).pan(0.0, 1.0);
        let height = 8.0 * 20f32.to_radians().tan();
        assert!(near(camera.target, [0.0, height, 0.0]), "{:?}", camera.target);
        assert!(near(camera.eye, [0.0, height, 4.0]), "{:?}", camera.eye);
    }

    #[test]
    fn a_framed_ball_touches_the_edge_of_the_picture() {
        let mut camera = camera();
        Orbit(&mut camera).frame(Vec3::X, 1.0, 2.0);
        let distance = Vec3::from(camera.eye).distance(Vec3::X);
        assert!((distance * 20f32.to_radians().sin() - 1.0).abs() < 1e-5);
    }

    #[test]
    fn every_side_looks_at_the_target_with_a_way_up() {
        for side in [Side::Front, Side::Back, Side::Left, Side::Right, Side::Top, Side::Bottom] {
            let mut camera = camera();
            Orbit(&mut camera).look_from(side);
            let [right, up, back] = axes(&camera);
            assert!(right.is_normalized() && up.is_normalized());
            assert!(near(back.into(), side.direction().into()));
        }
    }
}
