/// A pinhole camera in glTF's frame: right-handed, +Y up, metres.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// The name that `--camera` chooses it by.
    pub name: String,
    /// Where the camera stands.
    pub eye: [f32; 3],
    /// What it looks at; differs from `eye`.
    pub target: [f32; 3],
    /// Which way is up; not parallel to the line of sight.
    pub up: [f32; 3],
    /// Vertical field of view in degrees, above 0 and below 180.
    pub fov_deg: f32,
    /// Distance of the near plane in metres; `None` lets the engine choose a hundredth of the
    /// distance from eye to target.
    pub near: Option<f32>,
}
