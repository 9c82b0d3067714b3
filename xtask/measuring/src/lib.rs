//! What `report` asks to be measured, and what it is told.
//!
//! Times must be those of an optimised program, whereas the commands are built for quick turnaround. So the measuring is done
//! by a program of its own, whose `main` is [`main`]: it reads a [`Request`] and writes an [`Event`] a line.

mod program;

use jointproof::toolkit::measure::{Measurement, Options};
pub use program::main;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What is to be measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Request {
    /// Identifiers of formulas.
    pub formulas: Vec<String>,
    /// How much.
    pub options: Options,
}

/// What happens while measuring.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Event {
    /// The measuring has begun.
    Begun(Build),
    /// The errors of this formula are known.
    Compared(String),
    /// This formula was timed for the first time.
    Timed(String),
    /// This formula is done.
    Measured(Box<Measurement>),
}

/// How the measured program was built.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Build {
    /// The compiler's version.
    pub compiler: String,
    /// The platform it was built for.
    pub target: String,
    /// Cargo profile and optimisation level.
    pub profile: String,
    /// Flags given beside those of the profile; empty by default.
    pub flags: String,
}

impl Build {
    /// Of the program that runs.
    pub fn this() -> Self {
        const FLAGS: &str = env!("BUILT_WITH");
        Self {
            compiler: env!("BUILT_BY").into(),
            target: env!("BUILT_FOR").into(),
            profile: env!("BUILT_IN").into(),
            flags: FLAGS.into(),
        }
    }
}
