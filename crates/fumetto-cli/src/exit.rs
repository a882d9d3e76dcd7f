//! How the program ends: what it says, and the code it leaves.

use std::any::Any;
use std::panic::{self, AssertUnwindSafe};
use std::process::ExitCode;

use fumetto_scene::Report;

use crate::console;

const FAILED: u8 = 1;
const WRONG_USAGE: u8 = 2;
/// As shells report a program that SIGINT ended: 128 and the signal's number.
const INTERRUPTED: u8 = 130;

/// The ends that are no failures of the work itself.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Stop {
    /// The command line asks for something that cannot be.
    #[error("{0}")]
    Usage(String),
    /// Ctrl-C.
    #[error("interrupted; finished files stay, and a sequence goes on with --resume")]
    Interrupted,
}

/// Runs a command; says what went wrong, and gives the code to leave with.
///
/// A bug ends as a failure too, after unwinding has removed every half-written file: whoever calls
/// this from a script meets the documented codes only.
pub(crate) fn code_of(command: impl FnOnce() -> anyhow::Result<ExitCode>) -> ExitCode {
    panic::set_hook(Box::new(|bug| {
        let place = bug.location().map(|place| format!(" at {}:{}", place.file(), place.line()));
        let what = message_of(bug.payload());
        let place = place.unwrap_or_default();
        console::say(&format!("error: fumetto has a bug{place}: {what}; please report it with the scene"));
    }));
    match panic::catch_unwind(AssertUnwindSafe(command)) {
        Ok(Ok(code)) => code,
        Ok(Err(error)) => fail(&error),
        Err(_) => ExitCode::from(FAILED),
    }
}

fn message_of(payload: &(dyn Any + Send)) -> &str {
    payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("no message")
}

fn fail(error: &anyhow::Error) -> ExitCode {
    if let Some(report) = error.downcast_ref::<Report>() {
        console::say(&report.render(console::stderr_is_coloured()));
        return ExitCode::from(FAILED);
    }
    console::say(&format!("error: {error:#}"));
    match error.downcast_ref::<Stop>() {
        Some(Stop::Usage(_)) => ExitCode::from(WRONG_USAGE),
        Some(Stop::Interrupted) => ExitCode::from(INTERRUPTED),
        None => ExitCode::from(FAILED),
    }
}
