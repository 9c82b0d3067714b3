//! Evidence for the formula of the parent module.

use super::Joining;
use crate::formula::proof::Proved;

impl Proved for Joining {}
