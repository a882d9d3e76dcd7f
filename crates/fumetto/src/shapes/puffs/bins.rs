//! Puffs by where on the screen they are: lists of what each tile may show, from near to far, made and kept on
//! the device.
//!
//! ```text
//! puffs ─▶ project ─▶ count ─▶ place ─▶ cover ─▶ list ─▶ walked by bodies and outlines
//! ```
//!
//! Room is set aside for as many entries as there can be, so nothing overflows and nothing is read back.

use super::{
    atlas::{Atlas, HEIGHTS_SLOT},
    scene::Subject,
};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups};

/// Width of a tile of the finest level, in pixels, and slices of depth. Also in `bins.wgsl`.
const TILE_PX: u32 = 16;
const SLICES: u32 = 32;
/// Tiles that a workgroup of `cover` has: columns and rows. Also in `bins.wgsl`.
const COVER_TILES: [u32; 2] = [32, 8];
/// Enough for any texture. Also in `bins.wgsl`.
const MAX_LEVELS: usize = 12;
/// Tiles that a puff is listed in at most: three by three.
const MOST_TILES: u32 = 9;
/// Entries in a row of their texture. Also in `bins.wgsl`.
const ENTRY_ROW: u32 = 4096;
/// Puffs in a row of their texture, and texels of each. Also in `projected.wgsl`.
const PROJECTED_ROW: u32 = 1024;
const PROJECTED_TEXELS: u32 = 4;

const ENTRY_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg32Uint;
const PROJECTED_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Uint;
const FOUND_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Uint;

/// What walks the lists binds first, as `walk.wgsl` tells; [`Bins::walk`] has the resources.
pub(crate) const WALK_SLOTS: [Slot; 9] = [
    Slot::Uniform,
    Slot::Uniform,
    Slot::Read,
    Slot::Read,
    Slot::Read,
    Slot::ReadTexels(ENTRY_FORMAT),
    Slot::ReadTexels(PROJECTED_FORMAT),
    HEIGHTS_SLOT,
    Slot::WriteTexels(FOUND_FORMAT),
];

/// The lists for pictures of one size and scenes of one number of puffs.
#[derive(Debug)]
pub(crate) struct Bins {
    pub(crate) size: [u32; 2],
    pub(crate) count: u32,
    uniform: wgpu::Buffer,
    /// Of all levels.
    tile_count: u32,
    /// Puffs as the camera sees them, as `projected.wgsl` tells.
    pub(crate) projected: wgpu::TextureView,
    entries: wgpu::TextureView,
    summary: wgpu::Buffer,
    slices: wgpu::Buffer,
    tiles: wgpu::Buffer,
    /// Tiles of the finest level that show anything.
    covered: wgpu::Buffer,
    /// Runs of them, and the arguments of a draw over these and of a dispatch over the tiles.
    runs: wgpu::Buffer,
    draw: wgpu::Buffer,
    pub(crate) dispatch: wgpu::Buffer,
    /// What a walk has found in each pixel of these tiles.
    found: wgpu::TextureView,
}

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Binning {
    project: ComputePipeline,
    count: ComputePipeline,
    place: ComputePipeline,
    cover: ComputePipeline,
    list: ComputePipeline,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct BinsUniform {
    count: u32,
    levels: u32,
    size_px: [f32; 2],
    level: [[u32; 4]; MAX_LEVELS],
}

impl Bins {
    /// For `count` puffs in pictures of `size` pixels.
    pub(crate) fn new(gpu: &Gpu, count: u32, size: [u32; 2]) -> Self {
        let (uniform, tile_count) = BinsUniform::new(count, size);
        let pool = crate::gpu::TexturePool::default();
        let frame = Frame::new(gpu, &pool, "shapes.puffs.bins");
        let buffer = |label, words: u32, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: u64::from(words) * 4,
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST | usage,
                mapped_at_creation: false,
            })
        };
        let (plain, indirect) = (wgpu::BufferUsages::empty(), wgpu::BufferUsages::INDIRECT);
        // Two pixels to a texel.
        let found = [uniform.level[0][1] * TILE_PX / 2, uniform.level[0][2] * TILE_PX];
        let rows = |items: u32, row| items.max(1).div_ceil(row);
        Self {
            size,
            count,
            uniform: frame.uniform("shapes.puffs.bins.uniform", &uniform),
            tile_count,
            projected: texture(
                gpu,
                "shapes.puffs.projected",
                [PROJECTED_TEXELS * PROJECTED_ROW, rows(count, PROJECTED_ROW)],
                PROJECTED_FORMAT,
            ),
            entries: texture(
                gpu,
                "shapes.puffs.entries",
                [ENTRY_ROW, rows(MOST_TILES * count, ENTRY_ROW)],
                ENTRY_FORMAT,
            ),
            summary: buffer("shapes.puffs.bins.summary", 6, plain),
            slices: buffer("shapes.puffs.bins.slices", tile_count * SLICES, plain),
            tiles: buffer("shapes.puffs.bins.tiles", tile_count * 2, plain),
            covered: buffer("shapes.puffs.bins.covered", tile_count, plain),
            runs: buffer("shapes.puffs.bins.runs", tile_count, plain),
            draw: buffer("shapes.puffs.bins.draw", 4, indirect),
            dispatch: buffer("shapes.puffs.bins.dispatch", 3, indirect),
            found: texture(gpu, "shapes.puffs.found", found, FOUND_FORMAT),
        }
    }

    /// What fills the first of the slots of a kernel that walks the lists.
    pub(crate) fn walk<'a>(&'a self, subject: Subject<'a>) -> Vec<wgpu::BindingResource<'a>> {
        use wgpu::BindingResource::TextureView;
        vec![
            subject.view.as_entire_binding(),
            self.uniform.as_entire_binding(),
            self.summary.as_entire_binding(),
            self.tiles.as_entire_binding(),
            self.covered.as_entire_binding(),
            TextureView(&self.entries),
            TextureView(&self.projected),
            TextureView(&subject.scene.atlas.heights),
            TextureView(&self.found),
        ]
    }

    /// What `covered.wgsl` reads.
    pub(crate) fn covered(&self) -> [wgpu::BindingResource<'_>; 3] {
        [
            self.uniform.as_entire_binding(),
            self.runs.as_entire_binding(),
            wgpu::BindingResource::TextureView(&self.found),
        ]
    }

    /// Draws the tiles that show anything.
    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.draw_indirect(&self.draw, 0);
    }
}

/// A texture that kernels write, and read with no sampler.
fn texture(gpu: &Gpu, label: &str, size: [u32; 2], format: wgpu::TextureFormat) -> wgpu::TextureView {
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

impl BinsUniform {
    /// With how many tiles there are on all levels.
    fn new(count: u32, size: [u32; 2]) -> (Self, u32) {
        let mut uniform =
            Self { count, levels: 0, size_px: size.map(|pixels| pixels as f32), level: [[0; 4]; MAX_LEVELS] };
        let mut grid = size.map(|pixels| pixels.div_ceil(TILE_PX));
        let mut tiles = 0;
        for level in &mut uniform.level {
            *level = [tiles, grid[0], grid[1], 0];
            tiles += grid[0] * grid[1];
            uniform.levels += 1;
            if grid == [1, 1] {
                break;
            }
            grid = grid.map(|tiles| tiles.div_ceil(2));
        }
        (uniform, tiles)
    }
}

impl Binning {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        use Slot::{Read, ReadTexels, Uniform, Write, WriteTexels};
        let slots = [Uniform, Uniform, Uniform, Uniform, Uniform, Read, Write, WriteTexels(PROJECTED_FORMAT)];
        let [project] = kernels(gpu, shader!("shapes/puffs/project"), &slots, ["main"]);
        let slots = [
            Uniform,
            Uniform,
            ReadTexels(PROJECTED_FORMAT),
            Write,
            Write,
            Write,
            Write,
            Write,
            Write,
            Write,
            WriteTexels(ENTRY_FORMAT),
        ];
        let [count, place, cover, list] =
            kernels(gpu, shader!("shapes/puffs/bin"), &slots, ["count", "place", "cover", "list"]);
        Self { project, count, place, cover, list }
    }

    /// Lists the puffs of the cel in the tiles that they may touch.
    pub(crate) fn record(&self, frame: &mut Frame<'_>, subject: Subject<'_>, bins: &Bins) {
        for counts in [&bins.summary, &bins.slices, &bins.draw, &bins.dispatch] {
            frame.encoder.clear_buffer(counts, 0, None);
        }
        self.project(frame, subject, bins);
        let bindings = [
            subject.view.as_entire_binding(),
            bins.uniform.as_entire_binding(),
            wgpu::BindingResource::TextureView(&bins.projected),
            bins.summary.as_entire_binding(),
            bins.slices.as_entire_binding(),
            bins.tiles.as_entire_binding(),
            bins.covered.as_entire_binding(),
            bins.runs.as_entire_binding(),
            bins.draw.as_entire_binding(),
            bins.dispatch.as_entire_binding(),
            wgpu::BindingResource::TextureView(&bins.entries),
        ];
        let grid = bins.size.map(|pixels| pixels.div_ceil(TILE_PX));
        let cover = [grid[0].div_ceil(COVER_TILES[0]), grid[1].div_ceil(COVER_TILES[1]), 1];
        for (label, pipeline, groups) in [
            ("shapes.puffs.count", &self.count, workgroups(bins.count)),
            ("shapes.puffs.place", &self.place, workgroups(bins.tile_count)),
            ("shapes.puffs.cover", &self.cover, cover),
            ("shapes.puffs.list", &self.list, workgroups(bins.count)),
        ] {
            frame.compute(label, pipeline, &bindings, groups);
        }
    }

    fn project(&self, frame: &mut Frame<'_>, subject: Subject<'_>, bins: &Bins) {
        let Atlas { uniform: atlas, .. } = &subject.scene.atlas;
        frame.compute(
            "shapes.puffs.project",
            &self.project,
            &[
                subject.view.as_entire_binding(),
                bins.uniform.as_entire_binding(),
                atlas.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                subject.lights.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                bins.summary.as_entire_binding(),
                wgpu::BindingResource::TextureView(&bins.projected),
            ],
            workgroups(bins.count),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: BinsUniform, "Bins" of "shapes/puffs/bin" { count, levels, size_px, level });

    #[test]
    fn levels_end_with_one_tile_however_large_a_picture_is() {
        for (size, levels, tiles) in [([1, 1], 1, 1), ([1280, 720], 8, 4844), ([8192, 8192], 10, 349_525)] {
            let (uniform, count) = BinsUniform::new(0, size);
            assert_eq!((uniform.levels, count), (levels, tiles), "{size:?}");
            assert_eq!(uniform.level[levels as usize - 1][1..3], [1, 1]);
        }
    }
}
