//! Ctrl-C, asked for between two frames.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::Context as _;

use crate::exit::{INTERRUPTED, Stop};

/// Whether the user wants to stop.
#[derive(Clone, Debug)]
pub(crate) struct Interrupt {
    asked: Arc<AtomicBool>,
}

impl Interrupt {
    /// From now on Ctrl-C (and a request to terminate) is noted instead of ending the program. The
    /// second one ends it all the same: a graphics driver may hang.
    ///
    /// Where the caller has these signals ignored, as `nohup` does, they stay ignored.
    pub(crate) fn listen() -> anyhow::Result<Self> {
        let asked = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&asked);
        let listening = ctrlc::try_set_handler(move || {
            if flag.swap(true, Ordering::SeqCst) {
                std::process::exit(INTERRUPTED.into());
            }
        });
        match listening {
            Ok(()) | Err(ctrlc::Error::MultipleHandlers) => Ok(Self { asked }),
            Err(error) => Err(error).context("cannot listen for Ctrl-C"),
        }
    }

    /// Ends the work, by an error, if the user wants that.
    pub(crate) fn check(&self) -> Result<(), Stop> {
        if self.asked.load(Ordering::SeqCst) { Err(Stop::Interrupted) } else { Ok(()) }
    }
}
