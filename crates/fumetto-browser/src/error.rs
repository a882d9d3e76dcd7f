use std::io;

/// Why a page could not be driven.
#[derive(Debug, thiserror::Error)]
pub enum BrowserError {
    /// There is no Chromium.
    #[error(
        "Chromium was not found; install it (Debian: `apt-get install chromium`) or name its program in FUMETTO_CHROMIUM"
    )]
    Missing,
    /// It could not be started, or its files not be read.
    #[error("the browser could not be run: {0}")]
    Io(#[from] io::Error),
    /// It ended by itself.
    #[error("the browser has ended; it last wrote:\n{0}")]
    Ended(String),
    /// It has not answered.
    #[error("the browser took longer than {secs} s over {what}")]
    TooLate {
        /// What was waited for.
        what: String,
        /// For how long.
        secs: u64,
    },
    /// It did not understand, or could not.
    #[error("the browser refused {method}: {message}")]
    Refused {
        /// Of the protocol.
        method: String,
        /// In its own words.
        message: String,
    },
    /// A script on the page threw.
    #[error("a script threw: {0}")]
    Threw(String),
}
