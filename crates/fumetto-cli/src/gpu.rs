//! The graphics device, and the errors that it reports on the side.

use std::sync::{Arc, Mutex, PoisonError};

use anyhow::bail;
use fumetto::{Gpu, GpuError};

/// Keeps the first error that the device reports outside of any call. Without somebody listening,
/// `wgpu` ends the program.
#[derive(Clone, Debug)]
pub(crate) struct Trouble {
    first: Arc<Mutex<Option<String>>>,
}

/// Opens the best device that there is.
pub(crate) fn open() -> Result<(Gpu, Trouble), GpuError> {
    let gpu = pollster::block_on(Gpu::headless())?;
    let trouble = Trouble { first: Arc::default() };
    let listener = trouble.clone();
    gpu.device.on_uncaptured_error(Arc::new(move |error| listener.note(error.to_string())));
    let listener = trouble.clone();
    gpu.device.set_device_lost_callback(move |reason, message| {
        // `Destroyed` is the end of an orderly life.
        if reason == wgpu::DeviceLostReason::Unknown {
            listener.note(format!("the device was lost: {message}"));
        }
    });
    Ok((gpu, trouble))
}

impl Trouble {
    fn note(&self, message: String) {
        self.first.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(message);
    }

    /// An error if the device has reported any.
    pub(crate) fn check(&self) -> anyhow::Result<()> {
        match self.first.lock().unwrap_or_else(PoisonError::into_inner).take() {
            Some(message) => bail!("the graphics device failed: {message}"),
            None => Ok(()),
        }
    }
}

/// An adapter in words: what it is called, how it is driven.
pub(crate) fn describe(adapter: &wgpu::AdapterInfo) -> String {
    format!("{} ({})", adapter.name, adapter.backend)
}
