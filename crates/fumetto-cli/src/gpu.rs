//! The graphics device.

use fumetto::{Gpu, GpuError, Trouble};

/// Opens the best device that there is.
pub(crate) fn open() -> Result<(Gpu, Trouble), GpuError> {
    let gpu = pollster::block_on(Gpu::headless())?;
    let trouble = Trouble::of(&gpu);
    Ok((gpu, trouble))
}

/// An adapter in words: what it is called, how it is driven.
pub(crate) fn describe(adapter: &wgpu::AdapterInfo) -> String {
    format!("{} ({})", adapter.name, adapter.backend)
}
