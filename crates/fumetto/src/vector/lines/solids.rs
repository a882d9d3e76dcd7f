//! The triangles and places of lines of a moment, on the processor.

use fumetto_scene::{EdgeKind, Object};
use glam::Vec3;
use rayon::prelude::*;

use crate::{
    Player,
    gpu::{Gpu, GpuError, read_items},
    ink::follows_edges,
    shapes::mesh::{Candidate, Triangle, bit, unpacked},
};

/// `Vertex` of `mesh.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
struct Packed {
    position: [f32; 3],
    normal: u32,
}

/// All models and surfaces of a moment.
#[derive(Clone, Debug, Default)]
pub(crate) struct Solids {
    pub(crate) positions: Vec<Vec3>,
    /// Unit vectors, one for each position.
    pub(crate) normals: Vec<Vec3>,
    pub(crate) triangles: Vec<Triangle>,
    /// For each triangle, a number that it shares with those that it hangs together with.
    pub(crate) sheets: Vec<u32>,
    pub(crate) parts: Vec<PartLook>,
    /// Where lines may run, apart from contours of triangles.
    pub(crate) candidates: Vec<Candidate>,
}

/// What lines need to know of a part.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PartLook {
    pub(crate) object: u32,
    pub(crate) is_double_sided: bool,
    /// Whether it hides what is behind it: not where it has holes, which are in its texture, nor where no triangle
    /// of it is in the picture.
    pub(crate) hides: bool,
}

impl Solids {
    /// Those that the objects that `members` numbers are drawn with.
    pub(crate) async fn read(gpu: &Gpu, player: &Player, members: &[usize]) -> Result<Self, GpuError> {
        let geometry = &player.geometry;
        let drawn = player.drawn();
        let wanted = |object: usize| members.contains(&object) && any_line(drawn[object]);
        if !members.iter().any(|&object| wanted(object)) {
            return Ok(Self::default());
        }
        let look = |part: &crate::shapes::mesh::Part| PartLook {
            object: part.object,
            is_double_sided: part.is_double_sided(),
            hides: !part.has_holes() && members.contains(&(part.object as usize)),
        };
        let meshes = &player.meshes;
        let mut packed: Vec<Packed> = read_items(gpu, &meshes.vertices, 0..meshes.source_count).await?;
        let mut triangles = geometry.triangles.clone();
        let mut sheets = geometry.pieces.clone();
        for reserved in meshes.reserved.iter().filter(|reserved| members.contains(&reserved.object)) {
            // A surface's vertices go to where the others end.
            let moved = packed.len() as u32;
            let counters: Vec<[u32; 8]> = read_items(gpu, &reserved.counters, 0..1).await?;
            let [.., vertices, made, _, _] = counters[0];
            let first = reserved.vertices.start;
            packed.extend(read_items::<Packed>(gpu, &meshes.vertices, first..first + vertices).await?);
            let start = reserved.triangles.start;
            let made: Vec<Triangle> = read_items(gpu, &meshes.triangles, start..start + made).await?;
            triangles.extend(made.into_iter().map(|triangle| Triangle {
                corners: triangle.corners.map(|corner| corner - first + moved),
                part: triangle.part,
            }));
        }
        // Those that are made are one for each part; no model has as many pieces.
        sheets.extend(triangles[sheets.len()..].iter().map(|triangle| u32::MAX - 1 - triangle.part));
        let edges = &meshes.edges;
        let mut candidates: Vec<Candidate> = read_items(gpu, &edges.candidates, 0..edges.count).await?;
        candidates.retain(|candidate| candidate.bits & bit::CONTOUR == 0 && wanted(candidate.object()));
        let (positions, normals) =
            packed.par_iter().map(|vertex| (Vec3::from(vertex.position), unpacked(vertex.normal))).unzip();
        Ok(Self {
            positions,
            normals,
            triangles,
            sheets,
            parts: geometry.parts.iter().map(look).collect(),
            candidates,
        })
    }
}

/// Whether any of an object's pens follows its edges or contours.
fn any_line(object: &Object) -> bool {
    EdgeKind::ALL.iter().any(|&kind| follows_edges(object, kind))
}
