//! Where models are, so that what touches them is found: triangles by the cells of a grid that they come through.

use bytemuck::{Pod, Zeroable};
use glam::{UVec3, Vec3};
use wgpu::util::DeviceExt as _;

use crate::{gpu::Gpu, shapes::mesh::Geometry};

/// Cells along the longest side at most.
const MOST_CELLS: f32 = 64.0;

/// Entries of all cells' lists at most.
const MOST_ENTRIES: usize = 1 << 22;

/// Triangles of which it knows at most: their corners fill 96 MiB.
const MOST_TRIANGLES: usize = 2 << 20;

/// `Ground` of `ground.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub(super) struct GroundUniform {
    low: Vec3,
    cell: f32,
    counts: UVec3,
    pad: u32,
}

/// The models of a scene, as they stand at the beginning.
#[derive(Debug)]
pub(super) struct Ground {
    pub(super) uniform: GroundUniform,
    /// Where each cell's list begins and the last one ends, and then these lists: numbers of triangles.
    pub(super) cells: wgpu::Buffer,
    /// Three for each triangle.
    pub(super) corners: wgpu::Buffer,
}

impl Ground {
    /// Of `geometry`, for particles with radii up to `largest_m`.
    pub(super) fn new(gpu: &Gpu, geometry: &Geometry, largest_m: f32) -> Self {
        let triangles: Vec<_> = triangles(geometry).take(MOST_TRIANGLES).collect();
        let (uniform, cells) = sorted(&triangles, largest_m);
        let corners: Vec<[f32; 4]> =
            triangles.as_flattened().iter().map(|at| at.extend(0.0).into()).collect();
        let list = |label, contents: &[u8]| {
            gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some(label),
                contents: if contents.is_empty() { &[0; 48] } else { contents },
                usage: wgpu::BufferUsages::STORAGE,
            })
        };
        Self {
            uniform,
            cells: list("paint.ground.cells", bytemuck::cast_slice(&cells)),
            corners: list("paint.ground.corners", bytemuck::cast_slice(&corners)),
        }
    }
}

/// All that lie anywhere.
fn triangles(geometry: &Geometry) -> impl Iterator<Item = [Vec3; 3]> {
    let placed = geometry.triangles.iter().map(|triangle| {
        let world_from_part = geometry.parts[triangle.part as usize].world_from_part;
        triangle
            .corners
            .map(|corner| world_from_part.transform_point3(geometry.sources[corner as usize].position.into()))
    });
    placed.filter(|corners| corners.iter().all(|corner| corner.is_finite()))
}

/// The grid, and the triangles in each of its cells: as many cells as there is room for.
fn sorted(triangles: &[[Vec3; 3]], largest_m: f32) -> (GroundUniform, Vec<u32>) {
    let low = triangles.as_flattened().iter().copied().reduce(Vec3::min).unwrap_or_default();
    let high = triangles.as_flattened().iter().copied().reduce(Vec3::max).unwrap_or_default();
    let longest = (high - low).max_element();
    // A particle then comes into few of them.
    let mut cell = (longest / MOST_CELLS).max(largest_m).max(f32::MIN_POSITIVE);
    loop {
        let counts = ((high - low) / cell).floor().as_uvec3() + 1;
        let uniform = GroundUniform { low, cell, counts, pad: 0 };
        if let Some(lists) = lists(&uniform, triangles) {
            return (uniform, lists);
        }
        cell *= 2.0;
    }
}

/// Where each cell's list begins, then all lists; `None` if there is no room for them.
fn lists(grid: &GroundUniform, triangles: &[[Vec3; 3]]) -> Option<Vec<u32>> {
    let count = grid.counts.element_product() as usize;
    let mut entries: Vec<[u32; 2]> = Vec::new();
    for (number, corners) in (0..).zip(triangles) {
        for cell in cells_of(grid, corners) {
            entries.push([cell, number]);
            if entries.len() > MOST_ENTRIES.max(triangles.len()) {
                return None;
            }
        }
    }
    entries.sort_unstable();
    let first = count as u32 + 1;
    let mut all = vec![first; count + 1];
    for (index, [cell, _]) in (1..).zip(&entries) {
        all[*cell as usize + 1] = first + index;
    }
    for cell in 1..=count {
        all[cell] = all[cell].max(all[cell - 1]);
    }
    all.extend(entries.iter().map(|[_, number]| number));
    Some(all)
}

/// Cells whose ball around them reaches a triangle's plane, of those in the box around it.
fn cells_of(grid: &GroundUniform, corners: &[Vec3; 3]) -> impl Iterator<Item = u32> {
    let last = grid.counts - 1;
    let cell_of = |place: Vec3| ((place - grid.low) / grid.cell).floor().max(Vec3::ZERO).as_uvec3().min(last);
    let [a, b, c] = *corners;
    let (first, end) = (cell_of(a.min(b).min(c)), cell_of(a.max(b).max(c)));
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let (low, cell, counts) = (grid.low, grid.cell, grid.counts);
    let reach = 0.87 * cell;
    let all = (first.z..=end.z).flat_map(move |z| {
        (first.y..=end.y).flat_map(move |y| (first.x..=end.x).map(move |x| UVec3::new(x, y, z)))
    });
    let is_near = move |at: &UVec3| {
        let middle = low + (at.as_vec3() + 0.5) * cell;
        normal.dot(middle - a).abs() <= reach
    };
    all.filter(is_near).map(move |at| (at.z * counts.y + at.y) * counts.x + at.x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: GroundUniform, "Ground" of "paint/touch" { low, cell, counts });

    fn list(lists: &[u32], cell: usize) -> &[u32] {
        &lists[lists[cell] as usize..lists[cell + 1] as usize]
    }

    #[test]
    fn each_cell_lists_the_triangles_that_come_through_it() {
        let flat = |y: f32| [Vec3::new(0.0, y, 0.0), Vec3::new(4.0, y, 0.0), Vec3::new(0.0, y, 4.0)];
        let triangles = [flat(0.0), flat(4.0)];
        let (grid, lists) = sorted(&triangles, 1.0);
        assert_eq!((grid.cell, grid.counts), (1.0, UVec3::splat(5)));
        assert_eq!(list(&lists, 0), [0], "below");
        assert_eq!(list(&lists, 2 * 5 + 2), [0; 0], "between");
        assert_eq!(list(&lists, 4 * 5), [1], "above");
        let (_, none) = sorted(&[], 1.0);
        assert_eq!(list(&none, 0), [0; 0], "nothing at all");
    }

    #[test]
    fn small_particles_find_few_triangles_and_large_ones_few_cells() {
        let (fine, _) = sorted(&[[Vec3::ZERO, Vec3::X, Vec3::Y]], 1e-6);
        assert_eq!(fine.counts, UVec3::new(65, 65, 1));
        let (coarse, lists) = sorted(&[[Vec3::ZERO, Vec3::X, Vec3::Y]], 9.0);
        assert_eq!((coarse.counts, list(&lists, 0)), (UVec3::ONE, &[0][..]));
    }
}
