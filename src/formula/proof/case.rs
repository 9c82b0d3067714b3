//! Named cases and their purposes.

/// What a case is for.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "lowercase")]
pub enum Flag {
    /// Worked by hand.
    Hand,
    /// A limit that the document prints: of a factor, of a motion, or of a parameter that is ignored at 0.
    Limit,
    /// Drawn by the sampler.
    Random,
    /// Numerically hard.
    Hard,
    /// Where a search that climbs found the largest backward error.
    Worst,
    /// On a kink: see the register of kinks.
    Kink,
    /// Rejected.
    Invalid,
}

impl Flag {
    /// The name in golden files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Hand => "hand",
            Self::Limit => "limit",
            Self::Random => "random",
            Self::Hard => "hard",
            Self::Worst => "worst",
            Self::Kink => "kink",
            Self::Invalid => "invalid",
        }
    }
}

/// The identifier of the case that belongs to the state which a chapter follows.
pub const RUNNING: &str = "running";

/// A named case.
#[derive(Clone, Debug, PartialEq)]
pub struct Case<I> {
    /// Identifier, unique within the formula.
    pub id: String,
    /// Its purpose.
    pub flag: Flag,
    /// What it shows; may be empty.
    pub comment: &'static str,
    /// The inputs.
    pub inputs: I,
}

impl<I> Case<I> {
    /// A case worked by hand.
    pub fn hand(id: impl Into<String>, comment: &'static str, inputs: I) -> Self {
        Self::new(Flag::Hand, id, comment, inputs)
    }
    /// The case of the one state that a chapter follows from formula to formula, with numbers of few digits.
    pub fn running(comment: &'static str, inputs: I) -> Self {
        Self::hand(RUNNING, comment, inputs)
    }
    /// A limit that the document prints.
    pub fn limit(id: impl Into<String>, comment: &'static str, inputs: I) -> Self {
        Self::new(Flag::Limit, id, comment, inputs)
    }
    /// A numerically hard case.
    pub fn hard(id: impl Into<String>, comment: &'static str, inputs: I) -> Self {
        Self::new(Flag::Hard, id, comment, inputs)
    }
    /// A case that is rejected.
    pub fn invalid(id: impl Into<String>, comment: &'static str, inputs: I) -> Self {
        Self::new(Flag::Invalid, id, comment, inputs)
    }
    /// Any case.
    pub fn new(flag: Flag, id: impl Into<String>, comment: &'static str, inputs: I) -> Self {
        Self { id: id.into(), flag, comment, inputs }
    }
}
