//! Where copies of models stand, and their parts in them.

use fumetto_formats::{Model, Placed};
use fumetto_scene::{Mesh, Transform};
use glam::{EulerRot, Mat4, Quat, Vec3};

/// Where the corners of all triangles of `mesh`, which `model` holds, are at a moment.
pub(crate) fn triangles_at(mesh: &Mesh, model: &Model, time_secs: f32) -> Vec<[Vec3; 3]> {
    let of_part = |(placed, world_from_part): (Placed, Mat4)| {
        let part = &model.parts[placed.part];
        let corner =
            move |corner: u32| world_from_part.transform_point3(part.positions[corner as usize].into());
        part.triangles.iter().map(move |triangle| triangle.map(corner))
    };
    placements(mesh, model, time_secs).flat_map(of_part).collect()
}

/// Every part of every copy, and where it stands.
pub(super) fn placements<'a>(
    mesh: &'a Mesh,
    model: &Model,
    time_secs: f32,
) -> impl Iterator<Item = (Placed, Mat4)> + use<'a> {
    let placed = model.placed(time_secs);
    mesh.copies.iter().flat_map(move |copy| {
        let world_from_model = world_from_file(copy, mesh.z_up);
        let place = |placed: &Placed| {
            let world_from_part = world_from_model * Mat4::from_cols_array_2d(&placed.world_from_part);
            (*placed, world_from_part)
        };
        placed.iter().map(place).collect::<Vec<_>>()
    })
}

/// Where a transform brings what a file holds, whose z axis may point up.
pub(crate) fn world_from_file(transform: &Transform, z_up: bool) -> Mat4 {
    let up = if z_up { Mat4::from_rotation_x(-std::f32::consts::FRAC_PI_2) } else { Mat4::IDENTITY };
    matrix(transform) * up
}

fn matrix(transform: &Transform) -> Mat4 {
    let [x, y, z] = transform.rotation_deg.map(f32::to_radians);
    // About the x axis first, so it stands on the right.
    let rotation = Quat::from_euler(EulerRot::ZYX, z, y, x);
    Mat4::from_scale_rotation_translation(transform.scale.into(), rotation, transform.position.into())
}
