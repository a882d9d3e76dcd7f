use std::sync::{Arc, Mutex, PoisonError};

use super::{Gpu, GpuError};

/// Keeps the first error that a device reports outside of any call. Without somebody listening, `wgpu` ends the
/// program.
#[derive(Clone, Debug)]
pub struct Trouble {
    first: Arc<Mutex<Option<String>>>,
}

impl Trouble {
    /// Listens to `gpu` from now on, in place of whoever listened before.
    #[must_use]
    pub fn of(gpu: &Gpu) -> Self {
        let trouble = Self { first: Arc::default() };
        let listener = trouble.clone();
        gpu.device.on_uncaptured_error(Arc::new(move |error| listener.note(error.to_string())));
        let listener = trouble.clone();
        gpu.device.set_device_lost_callback(move |reason, message| {
            // `Destroyed` is the end of an orderly life.
            if reason == wgpu::DeviceLostReason::Unknown {
                listener.note(format!("the device was lost: {message}"));
            }
        });
        trouble
    }

    fn note(&self, message: String) {
        self.first.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(message);
    }

    /// Takes the error that the device has reported, if any.
    ///
    /// # Errors
    /// That error.
    pub fn check(&self) -> Result<(), GpuError> {
        match self.first.lock().unwrap_or_else(PoisonError::into_inner).take() {
            Some(message) => Err(GpuError::Lost(message)),
            None => Ok(()),
        }
    }
}
