use fumetto_scene::Camera;
use glam::{Mat4, Vec3};

/// What is drawn of a picture: all of it, or a tile. Counts samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Region {
    /// Of the whole picture.
    pub(crate) picture: [u32; 2],
    /// Where in it the region begins, from the top left.
    pub(crate) first: [u32; 2],
    pub(crate) size: [u32; 2],
}

/// The camera of one picture; [`ViewUniform`] is what shaders see of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    pub(crate) uniform: ViewUniform,
    /// Size of what is drawn, samples included.
    pub(crate) size: [u32; 2],
    /// Height of the picture that it is a part of, samples included.
    pub(crate) picture_height: u32,
}

/// `View` of `view.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct ViewUniform {
    view_from_world: Mat4,
    world_from_view: Mat4,
    size_px: [f32; 2],
    pub(crate) focal_px: f32,
    near: f32,
    middle_px: [f32; 2],
    first_px: [f32; 2],
}

impl Region {
    /// All of a picture.
    pub(crate) fn whole(picture: [u32; 2]) -> Self {
        Self { picture, first: [0, 0], size: picture }
    }
}

impl View {
    pub(crate) fn new(camera: &Camera, region: Region) -> Self {
        let Region { picture, first, size } = region;
        let pixels = |samples: [u32; 2]| samples.map(|samples| samples as f32);
        let (eye, target) = (Vec3::from(camera.eye), Vec3::from(camera.target));
        let view_from_world = glam::camera::rh::view::look_at_mat4(eye, target, Vec3::from(camera.up));
        let uniform = ViewUniform {
            view_from_world,
            world_from_view: view_from_world.inverse(),
            size_px: pixels(size),
            focal_px: 0.5 * picture[1] as f32 / (0.5 * camera.fov_deg.to_radians()).tan(),
            near: camera.near.unwrap_or(0.01 * eye.distance(target)),
            middle_px: pixels(picture).map(|side| 0.5 * side),
            first_px: pixels(first),
        };
        Self { uniform, size, picture_height: picture[1] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: ViewUniform, "View" of "shapes/puffs/nearest" { view_from_world, world_from_view, size_px, focal_px, near, middle_px, first_px });
}
