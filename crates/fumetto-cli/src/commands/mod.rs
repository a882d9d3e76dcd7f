//! One file for each command.

mod bake;
mod check;
mod doctor;
mod edit;
mod export;
mod info;
mod new;
mod render;
mod schema;

use std::process::ExitCode;

use crate::args::Command;

/// Does what the command line asks for.
pub(crate) fn run(command: Command) -> anyhow::Result<ExitCode> {
    match command {
        Command::Render(args) => render::run(&args),
        Command::Export(args) => export::run(&args),
        Command::Bake(args) => bake::run(&args),
        Command::Check(args) => check::run(&args),
        Command::Info(args) => info::run(&args),
        Command::New(args) => new::run(&args),
        Command::Edit(args) => edit::run(&args),
        Command::Schema => schema::run(),
        Command::Doctor => doctor::run(),
    }
}
