//! The outcome of a command.

use std::process::ExitCode;

/// The outcome of a command.
pub type Outcome = anyhow::Result<ExitCode>;

/// Bad usage that only the command can detect, such as a filter that matches nothing.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct Usage(pub String);

/// Success if all is well.
pub(crate) fn verdict(well: bool) -> ExitCode {
    if well { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
