//! `fumetto schema`

use std::process::ExitCode;

use crate::console;

pub(crate) fn run() -> anyhow::Result<ExitCode> {
    console::print(&serde_json::to_string_pretty(&fumetto_scene::schema())?)?;
    Ok(ExitCode::SUCCESS)
}
