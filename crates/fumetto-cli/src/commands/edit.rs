//! `fumetto edit`

use std::io;
use std::path::Path;
use std::process::{Command, ExitCode};

use anyhow::{Context as _, bail};

use crate::args::EditArgs;
use crate::exit::Stop;

/// The editor's program, which lies beside this one where it is installed.
const EDITOR: &str = "fumetto-editor";

pub(crate) fn run(args: &EditArgs) -> anyhow::Result<ExitCode> {
    if args.scene.as_deref() == Some(Path::new("-")) {
        let what = "the editor saves where it opens, so it cannot read standard input: name a scene's file";
        return Err(Stop::Usage(what.to_owned()).into());
    }
    let own = std::env::current_exe().context("cannot find out where fumetto itself lies")?;
    let editor = own.with_file_name(format!("{EDITOR}{}", std::env::consts::EXE_SUFFIX));
    let status = match command(&editor, args.scene.as_deref()).status() {
        Ok(status) => status,
        Err(error) if error.kind() == io::ErrorKind::NotFound => bail!(
            "the editor is not installed: there is no {}; build it with `cargo build --release -p {EDITOR}`",
            editor.display()
        ),
        Err(error) => return Err(error).with_context(|| format!("cannot start {}", editor.display())),
    };
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// A scene's name is no option, whatever it begins with.
fn command(editor: &Path, scene: Option<&Path>) -> Command {
    let mut command = Command::new(editor);
    command.arg("--").args(scene);
    command
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_is_no_option() {
        let command = command(Path::new("editor"), Some(Path::new("--help")));
        assert_eq!(command.get_args().collect::<Vec<_>>(), ["--", "--help"]);
    }
}
