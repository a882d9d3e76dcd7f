use wgpu::util::DeviceExt as _;

use super::{MeshScene, edges::Candidate};
use crate::gpu::{DrawList, Gpu};

/// The places of a scene's models where lines may run, on the device.
#[derive(Debug)]
pub(crate) struct EdgeScene {
    /// `Candidate`s of `candidate.wgsl`.
    pub(crate) candidates: wgpu::Buffer,
    pub(crate) count: u32,
    /// What stands for each vertex where lines meet, if any are drawn as strokes: see `seams.rs`.
    pub(crate) seams: wgpu::Buffer,
    /// For each of them the bit of the kind of edge that it is in the view that is drawn; 0 without a line. Four bits
    /// more are those of strokes.
    pub(crate) flags: wgpu::Buffer,
    /// Those with lines.
    pub(crate) list: DrawList,
}

/// The triangles of a surface that the device makes, in which contours may run.
#[derive(Debug)]
pub(crate) struct ContourScene {
    pub(crate) count: u32,
    /// For each of them the bit of silhouettes where one is in the view that is drawn; else 0.
    pub(crate) flags: wgpu::Buffer,
    /// Those with lines.
    pub(crate) list: DrawList,
}

/// A list of places where lines may run, and what is found of them in a view.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineScene<'a> {
    /// Whether each triangle of a surface is one. Then the first binding tells how many there are.
    pub(crate) of_surface: bool,
    pub(crate) candidates: &'a wgpu::Buffer,
    pub(crate) count: u32,
    pub(crate) flags: &'a wgpu::Buffer,
    pub(crate) list: &'a DrawList,
}

impl ContourScene {
    /// For so many triangles.
    pub(super) fn new(gpu: &Gpu, triangles: u32) -> Self {
        Self {
            count: triangles,
            flags: flags(gpu, "shapes.mesh.contours", triangles),
            // There may be millions, of which few have lines: too many to have indices for.
            list: DrawList::without_indices(gpu, "shapes.mesh.contours", triangles),
        }
    }
}

impl MeshScene {
    /// All that lines of the objects may run along which `members` numbers.
    pub(crate) fn lines(&self, members: &[usize]) -> Vec<LineScene<'_>> {
        let EdgeScene { candidates, count, flags, list, .. } = &self.edges;
        let models = LineScene { of_surface: false, candidates, count: *count, flags, list };
        let has_models = *count > 0 && members.iter().any(|&member| !self.objects[member].is_empty());
        let made = self.reserved.iter().filter(|reserved| members.contains(&reserved.object));
        let surfaces = made.filter_map(|reserved| {
            let ContourScene { count, flags, list } = reserved.contours.as_ref()?;
            let candidates = &reserved.counters;
            Some(LineScene { of_surface: true, candidates, count: *count, flags, list })
        });
        has_models.then_some(models).into_iter().chain(surfaces).collect()
    }
}

fn flags(gpu: &Gpu, label: &str, count: u32) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: u64::from(count.max(1)) * 4,
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    })
}

impl EdgeScene {
    pub(crate) fn new(gpu: &Gpu, candidates: &[Candidate], seams: &[[u32; 2]]) -> Self {
        let count = candidates.len() as u32;
        let nothing = [bytemuck::Zeroable::zeroed()];
        Self {
            candidates: gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("shapes.mesh.candidates"),
                contents: bytemuck::cast_slice(if candidates.is_empty() { &nothing } else { candidates }),
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
            }),
            count,
            seams: gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("shapes.mesh.seams"),
                contents: bytemuck::cast_slice(if seams.is_empty() { &[[0; 2]] } else { seams }),
                usage: wgpu::BufferUsages::STORAGE,
            }),
            flags: flags(gpu, "shapes.mesh.edges", count),
            list: DrawList::new(gpu, "shapes.mesh.lines", count, 1),
        }
    }
}
