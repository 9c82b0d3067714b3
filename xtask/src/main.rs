//! `cargo xtask`: golden files, audits, reports and the book, all from the one definition of each formula.

mod audit;
mod book;
mod console;
mod evidence;
mod figures;
mod files;
mod golden;
mod report;
mod scene;
mod selection;
mod statements;
mod tidy;
mod verify;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// The exit code of bad usage, which is also clap's.
const BAD_USAGE: u8 = 2;

/// Golden files, audits, reports and the book of jointproof.
///
/// Results go to standard output, everything else to standard error. The exit code is 0 if all is well, 1 if something
/// is off (it says what, where and by how much), 2 for bad usage.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask", version, max_term_width = 100)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Verify(verify::Arguments),
    Golden(golden::Arguments),
    Audit(audit::Arguments),
    Report(report::Arguments),
    Book(book::command::Arguments),
    Scene(scene::Arguments),
    Tidy(tidy::Arguments),
}

/// How a command ended.
type Outcome = anyhow::Result<ExitCode>;

/// Bad usage that only the command can see, as a filter that matches nothing.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
struct Usage(String);

fn main() -> ExitCode {
    let outcome = match Arguments::parse().command {
        Command::Verify(arguments) => verify::run(&arguments),
        Command::Golden(arguments) => golden::run(&arguments),
        Command::Audit(arguments) => audit::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Book(arguments) => book::command::run(&arguments),
        Command::Scene(arguments) => scene::run(&arguments),
        Command::Tidy(arguments) => tidy::run(&arguments),
    };
    outcome.unwrap_or_else(|error| {
        console::error(&format!("{error:#}"));
        if error.is::<Usage>() { ExitCode::from(BAD_USAGE) } else { ExitCode::FAILURE }
    })
}
