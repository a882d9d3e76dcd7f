//! Copies of a node's mesh: the extension `EXT_mesh_gpu_instancing`.

use glam::{Mat4, Quat, Vec3, Vec4};
use gltf_json::accessor::ComponentType::{F32, I8, I16};
use gltf_json::{Node, Value};

use super::document::Document;
use crate::FormatError;

const EXTENSION: &str = "EXT_mesh_gpu_instancing";

/// What an instance takes: a matrix is four times four numbers.
const ITEMS_AN_INSTANCE: usize = 4;

/// Where the copies of a node's mesh stand in the node, if it has any.
pub(super) fn read(
    document: &Document<'_>,
    element: &str,
    node: &Node,
) -> Result<Option<Vec<Mat4>>, FormatError> {
    let extension = node.extensions.as_ref().and_then(|extensions| extensions.others.get(EXTENSION));
    let Some(attributes) = extension.and_then(|extension| extension.get("attributes")) else {
        return Ok(None);
    };
    let accessor = |name: &str, width: usize| {
        let Some(index) = attributes.get(name).and_then(Value::as_u64) else { return Ok(None) };
        let index = usize::try_from(index).unwrap_or(usize::MAX);
        let accessor = document.accessor(element, index)?;
        if !accessor.is(width, &[F32, I8, I16]) {
            let problem = format!("accessor {index} cannot be its instances' {name}; export the model again");
            return Err(document.wrong(element, problem));
        }
        Ok(Some(accessor))
    };
    let translation = accessor("TRANSLATION", 3)?;
    let rotation = accessor("ROTATION", 4)?;
    let scale = accessor("SCALE", 3)?;

    let counts =
        [&translation, &rotation, &scale].map(|accessor| accessor.as_ref().map(|accessor| accessor.count));
    let Some(count) = counts.into_iter().flatten().next() else { return Ok(None) };
    if counts.into_iter().flatten().any(|other| other != count) {
        return Err(document
            .wrong(element, "its instances have attributes of different counts; export the model again"));
    }
    document.take_items(element, count.saturating_mul(ITEMS_AN_INSTANCE))?;
    let matrix = |i: usize| {
        let translation = translation.as_ref().map_or(Vec3::ZERO, |accessor| accessor.vector(i).into());
        let rotation = rotation.as_ref().map_or(Vec4::W, |accessor| accessor.vector(i).into());
        let scale = scale.as_ref().map_or(Vec3::ONE, |accessor| accessor.vector(i).into());
        let rotation = Quat::from_vec4(rotation.normalize_or(Vec4::W));
        Mat4::from_scale_rotation_translation(scale, rotation, translation)
    };
    Ok(Some((0..count).map(matrix).collect()))
}
