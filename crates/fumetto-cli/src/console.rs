//! Standard output and standard error, either of which may be closed or a file on a full disk.

use std::io::{self, IsTerminal as _, Write as _};

/// Says something on standard error. Nobody can be told if that fails.
pub(crate) fn say(line: &str) {
    writeln!(io::stderr().lock(), "{line}").ok();
}

/// Prints to standard output. A reader who left, as `head` does, has what it wanted.
pub(crate) fn print(text: &str) -> io::Result<()> {
    let mut out = io::stdout().lock();
    match writeln!(out, "{text}").and_then(|()| out.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

pub(crate) fn stdout_is_coloured() -> bool {
    io::stdout().is_terminal() && colour_is_wanted()
}

pub(crate) fn stderr_is_coloured() -> bool {
    io::stderr().is_terminal() && colour_is_wanted()
}

/// <https://no-color.org>
fn colour_is_wanted() -> bool {
    std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}
