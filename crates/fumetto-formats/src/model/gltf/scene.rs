//! The nodes of the scene that is shown.

use glam::{Mat4, Quat, Vec3, Vec4};
use gltf_json::Node as Json;

use super::document::{Document, label};
use super::instances;
use crate::FormatError;
use crate::model::rig::{Node, Pose};
use crate::notes::Notes;

/// A node of the scene.
pub(super) struct Visit {
    /// Its place in the document.
    pub(super) node: usize,
    /// The place of its parent among the visits.
    parent: Option<usize>,
}

/// The nodes of the default scene, every one after its parent.
pub(super) fn visit(document: &Document<'_>, notes: &mut Notes) -> Result<Vec<Visit>, FormatError> {
    let all = &document.root.nodes;
    let mut reached_from: Vec<Option<Origin>> = vec![None; all.len()];
    let mut visits: Vec<Visit> = Vec::new();
    // A list rather than recursion: a chain of nodes may be as long as it likes.
    let mut waiting: Vec<(usize, Option<usize>)> =
        roots(document, notes)?.into_iter().rev().map(|node| (node, None)).collect();
    while let Some((node, parent)) = waiting.pop() {
        let origin = parent.map_or(Origin::Scene, |parent| Origin::Node(visits[parent].node));
        let Some(json) = all.get(node) else {
            return Err(document.absent(&origin.label(all), "node", node));
        };
        if let Some(before) = reached_from[node].replace(origin) {
            let problem = format!(
                "both {} and {} have it as their child; nodes form trees, so export the model again",
                before.label(all),
                origin.label(all)
            );
            return Err(document.wrong(&node_label(all, node), problem));
        }
        let here = visits.len();
        visits.push(Visit { node, parent });
        let children = json.children.iter().flatten().rev();
        waiting.extend(children.map(|child| (child.value(), Some(here))));
    }
    Ok(visits)
}

/// What holds a node.
#[derive(Clone, Copy)]
enum Origin {
    Scene,
    Node(usize),
}

impl Origin {
    fn label(self, nodes: &[Json]) -> String {
        match self {
            Self::Scene => "the scene".to_owned(),
            Self::Node(node) => node_label(nodes, node),
        }
    }
}

fn node_label(nodes: &[Json], node: usize) -> String {
    label("node", node, nodes.get(node).and_then(|node| node.name.as_deref()))
}

/// The nodes that the default scene starts with; those that are nobody's children if there is no scene.
fn roots(document: &Document<'_>, notes: &mut Notes) -> Result<Vec<usize>, FormatError> {
    let root = &document.root;
    let shown = root.scene.map_or(0, |scene| scene.value());
    if let Some(scene) = root.scenes.get(shown) {
        let others = root.scenes.len() - 1;
        if others > 0 {
            notes.say_of_all(format!(
                "left out {others} other than {}",
                label("scene", shown, scene.name.as_deref())
            ));
        }
        return Ok(scene.nodes.iter().map(gltf_json::Index::value).collect());
    }
    if root.scene.is_some() {
        return Err(document.absent("the document", "scene", shown));
    }
    let mut child = vec![false; root.nodes.len()];
    for node in root.nodes.iter().filter_map(|node| node.children.as_ref()).flatten() {
        if let Some(child) = child.get_mut(node.value()) {
            *child = true;
        }
    }
    notes.say_of_all("it has no scene, so all its nodes are shown");
    Ok((0..root.nodes.len()).filter(|&node| !child[node]).collect())
}

/// How the visited nodes stand; without their parts, which are not yet read.
pub(super) fn nodes(
    document: &Document<'_>,
    visits: &[Visit],
    notes: &mut Notes,
) -> Result<Vec<Node>, FormatError> {
    let mut nodes = Vec::with_capacity(visits.len());
    for visit in visits {
        let json = &document.root.nodes[visit.node];
        let element = node_label(&document.root.nodes, visit.node);
        let rest = pose(json).ok_or_else(|| {
            document.wrong(
                &element,
                "its transform has numbers that single precision cannot hold; scale the model",
            )
        })?;
        if json.skin.is_some() {
            notes.say(&element, "it has a skin, which does not move: it is shown at rest");
        }
        let instances = instances::read(document, &element, json)?;
        nodes.push(Node { parent: visit.parent, rest, parts: 0..0, instances });
    }
    Ok(nodes)
}

/// How a node stands in its parent, unless that is beyond all numbers.
fn pose(json: &Json) -> Option<Pose> {
    if let Some(matrix) = json.matrix {
        let matrix = Mat4::from_cols_array(&matrix);
        return matrix.is_finite().then_some(Pose::Matrix(matrix));
    }
    let translation = json.translation.map_or(Vec3::ZERO, Vec3::from);
    let scale = json.scale.map_or(Vec3::ONE, Vec3::from);
    let rotation = json.rotation.map_or(Vec4::W, |rotation| Vec4::from(rotation.0));
    let finite = translation.is_finite() && scale.is_finite() && rotation.is_finite();
    let rotation = Quat::from_vec4(rotation.normalize_or(Vec4::W));
    finite.then_some(Pose::Parts { translation, rotation, scale })
}
