use fumetto_scene::SurfaceRoom;
use thiserror::Error;

use crate::gpu::Gpu;

/// A surface that the device has no room for.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "a surface with room for {count} {what} needs {needed} bytes for them, and this device allows {allowed}: \
     choose larger cells (fewer subdivisions, more pixels) or fewer particles"
)]
pub struct SurfaceTooLarge {
    what: &'static str,
    count: u64,
    needed: u64,
    allowed: u64,
}

/// Refuses what has buffers larger than the device binds.
///
/// # Errors
/// Names the first that is too large.
pub(super) fn check(gpu: &Gpu, room: SurfaceRoom) -> Result<(), SurfaceTooLarge> {
    let limits = gpu.device.limits();
    let allowed = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
    // Each of them is several buffers, one of which is nearly all of it; as one they err on the safe side.
    let too_large = room.parts().into_iter().find(|(_, count, bytes)| count * bytes > allowed);
    too_large.map_or(Ok(()), |(what, count, bytes)| {
        Err(SurfaceTooLarge { what, count, needed: count * bytes, allowed })
    })
}

/// What was left out of a surface for want of room, by the bits of `lattice.wgsl`; reads on from its name.
pub(crate) fn shortage(overflow: u32) -> Option<&'static str> {
    const COARSENED: u32 = 1;
    if overflow & !COARSENED != 0 {
        Some(
            "has holes: it did not fit the room that was planned for it. Choose larger cells or fewer particles",
        )
    } else if overflow != 0 {
        Some("has larger cells than were asked for: its particles are too far apart. Choose larger cells")
    } else {
        None
    }
}
