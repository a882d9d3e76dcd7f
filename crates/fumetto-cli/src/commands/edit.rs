//! `fumetto edit`

use std::io;
use std::process::{Command, ExitCode};

use anyhow::{Context as _, bail};

use crate::args::EditArgs;

/// The editor's program, which lies beside this one where it is installed.
const EDITOR: &str = "fumetto-editor";

pub(crate) fn run(args: &EditArgs) -> anyhow::Result<ExitCode> {
    let own = std::env::current_exe().context("cannot find out where fumetto itself lies")?;
    let editor = own.with_file_name(format!("{EDITOR}{}", std::env::consts::EXE_SUFFIX));
    let status = match Command::new(&editor).args(&args.scene).status() {
        Ok(status) => status,
        Err(error) if error.kind() == io::ErrorKind::NotFound => bail!(
            "the editor is not installed: there is no {}; build it with `cargo build --release -p {EDITOR}`",
            editor.display()
        ),
        Err(error) => return Err(error).with_context(|| format!("cannot start {}", editor.display())),
    };
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
