//! The requests of `report` for measurements, and the events returned.
//!
//! Times must be those of an optimised program, whereas the commands are built for quick turnaround. So measurements
//! are made by a separate program, whose `main` is [`main`]: it reads a [`Request`] and writes one [`Event`] per line.

mod program;

use jointproof::toolkit::measure::{Measurement, Options};
pub use program::main;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A request for measurements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Request {
    /// Identifiers of formulas.
    pub formulas: Vec<String>,
    /// The extent of the measurements.
    pub options: Options,
}

/// An event during measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Event {
    /// Measurement has started.
    Begun(Build),
    /// The errors of this formula are known.
    Compared(String),
    /// This formula was timed in the first half of the rounds.
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
    /// The build of the running program.
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
