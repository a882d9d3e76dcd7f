//! How the program ends: what it says, and the code it leaves.

use std::any::Any;
use std::panic::{self, AssertUnwindSafe};
use std::process::ExitCode;

use fumetto_scene::Report;

use crate::console;

const FAILED: u8 = 1;
const WRONG_USAGE: u8 = 2;
/// As shells report a program that SIGINT ended: 128 and the signal's number.
pub(crate) const INTERRUPTED: u8 = 130;

/// The ends that are no failures of the work itself.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Stop {
    /// The command line asks for something that cannot be.
    #[error("{0}")]
    Usage(String),
    /// Ctrl-C.
    #[error(
        "interrupted; finished files stay: a sequence goes on with --resume, and baking when it is begun again"
    )]
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
    console::say(&format!("error: {}", chain_of(error)));
    match error.downcast_ref::<Stop>() {
        Some(Stop::Usage(_)) => ExitCode::from(WRONG_USAGE),
        Some(Stop::Interrupted) => ExitCode::from(INTERRUPTED),
        None => ExitCode::from(FAILED),
    }
}

/// An error and its causes in one line. Causes whose words the error already has are not repeated.
fn chain_of(error: &anyhow::Error) -> String {
    error.chain().map(ToString::to_string).fold(String::new(), |told, cause| {
        if told.is_empty() {
            cause
        } else if told.contains(&cause) {
            told
        } else {
            format!("{told}: {cause}")
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn causes_are_told_once() {
        let error = anyhow::anyhow!("no room").context("cannot write: no room").context("a.png");
        assert_eq!(chain_of(&error), "a.png: cannot write: no room");
    }
}
