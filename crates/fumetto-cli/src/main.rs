//! `fumetto`: draws smoke, clouds and fog as a cartoonist would, from the shell.

mod args;
mod cache;
mod commands;
mod console;
mod exit;
mod gpu;
mod interrupt;
mod progress;
mod render;
mod scene;
mod stage;

use std::process::ExitCode;

use clap::Parser as _;

fn main() -> ExitCode {
    let cli = args::Cli::parse();
    exit::code_of(|| commands::run(cli.command))
}
