use fumetto_scene::Camera;
use glam::{Mat4, Vec3};

/// The camera of one picture; [`ViewUniform`] is what shaders see of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    pub(crate) uniform: ViewUniform,
    /// Size of the picture that is drawn, samples included.
    pub(crate) size: [u32; 2],
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
}

impl View {
    /// `size` counts samples.
    pub(crate) fn new(camera: &Camera, size: [u32; 2]) -> Self {
        let (eye, target) = (Vec3::from(camera.eye), Vec3::from(camera.target));
        let view_from_world = glam::camera::rh::view::look_at_mat4(eye, target, Vec3::from(camera.up));
        let uniform = ViewUniform {
            view_from_world,
            world_from_view: view_from_world.inverse(),
            size_px: [size[0] as f32, size[1] as f32],
            focal_px: 0.5 * size[1] as f32 / (0.5 * camera.fov_deg.to_radians()).tan(),
            near: camera.near.unwrap_or(0.01 * eye.distance(target)),
        };
        Self { uniform, size }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: ViewUniform, "View" of "shapes/puffs/body" { view_from_world, world_from_view, size_px, focal_px, near });
}
