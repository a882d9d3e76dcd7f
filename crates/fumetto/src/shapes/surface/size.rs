use fumetto_scene::SurfaceRoom;

use crate::{
    gpu::{Gpu, GpuError, read_items},
    shapes::mesh::Reserved,
};

/// Cells were made larger: `COARSENED` of `lattice.wgsl`. All other bits are of what was left out.
const COARSENED: u32 = 1;

/// How large one surface is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SurfaceSize {
    /// Number of its object in the scene.
    pub object: usize,
    /// Corners of triangles.
    pub vertices: u32,
    /// Triangles.
    pub triangles: u32,
    /// Bytes of graphics memory that are kept for it.
    pub bytes: u64,
    /// Whether its cells were made larger than asked for, so that it fits.
    pub coarsened: bool,
    /// Whether some of it had no room.
    pub cut: bool,
}

impl SurfaceSize {
    pub(super) async fn read(gpu: &Gpu, mesh: &Reserved, room: SurfaceRoom) -> Result<Self, GpuError> {
        // As `Counters` of `counters.wgsl`.
        let counters: Vec<u32> = read_items(gpu, &mesh.counters, 0..8).await?;
        Ok(Self {
            object: mesh.object,
            vertices: counters[4],
            triangles: counters[5],
            bytes: room.bytes(),
            coarsened: counters[6] & COARSENED != 0,
            cut: counters[6] & !COARSENED != 0,
        })
    }
}
