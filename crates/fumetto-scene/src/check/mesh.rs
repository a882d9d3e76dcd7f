use super::At;
use crate::file::{ObjectFile, ScaleFile, TransformFile, UpFile};
use crate::{Mesh, Transform};

/// Formats that models are read from.
const EXTENSIONS: [&str; 3] = [".glb", ".gltf", ".obj"];

pub(super) fn mesh(at: &At<'_>, file: &ObjectFile) -> Mesh {
    let transforms = file.transform.as_ref().map_or(&[][..], |transforms| transforms.as_slice());
    let place = at.key("transform");
    if place.exists() && transforms.is_empty() {
        let message = format!("the mesh {:?} has no copy: `transform` is an empty list", file.name);
        place.warning("no-copy", message, "leave `transform` out for one copy as it is in the file");
    }
    let copies = match &file.transform {
        None => vec![Transform::default()],
        Some(_) => transforms.iter().enumerate().map(|(i, file)| transform(&place.item(i), file)).collect(),
    };
    Mesh {
        model: model(&at.key("model"), file),
        z_up: file.up == Some(UpFile::Z),
        smooth_deg: file.smooth,
        copies,
        obstacle: file.obstacle.unwrap_or(false),
    }
}

fn model(at: &At<'_>, file: &ObjectFile) -> String {
    let Some(path) = &file.model else {
        let message = format!("the mesh {:?} has no model", file.name);
        at.error("no-model", message, "write model = \"house.glb\", the path of a .glb, .gltf or .obj file");
        return String::new();
    };
    let lower = path.to_lowercase();
    if !EXTENSIONS.iter().any(|extension| lower.ends_with(extension)) {
        let message = format!("{path:?} is neither a .glb, nor a .gltf, nor an .obj file");
        at.error("unknown-format", message, "export the model as glTF 2.0 (.glb)");
    }
    path.clone()
}

pub(super) fn transform(at: &At<'_>, file: &TransformFile) -> Transform {
    let scale = match file.scale {
        ScaleFile::One(one) => [one; 3],
        ScaleFile::Axes(axes) => axes,
    };
    if scale.contains(&0.0) {
        let message = "`scale` is 0, which leaves nothing of it".to_owned();
        at.key("scale").error("zero-scale", message, "to hide the object write visible = false");
    }
    Transform { position: file.position, rotation_deg: file.rotation, scale }
}
