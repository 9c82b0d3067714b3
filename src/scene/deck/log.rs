//! What is wrong in a deck, and what of it is left out, at places.

use super::source::Place;
use std::collections::HashSet;

/// The maximum number of faults that are kept; further ones are only counted.
const KEPT: usize = 100;

/// A fault at a place.
#[derive(Debug)]
pub(super) struct Raw {
    pub(super) place: Place,
    pub(super) found: String,
    pub(super) allowed: String,
}

/// Something that the scene does not have.
#[derive(Debug)]
pub(super) struct Note {
    pub(super) place: Place,
    pub(super) what: String,
    pub(super) matters: bool,
}

#[derive(Default)]
pub(super) struct Log {
    pub(super) faults: Vec<Raw>,
    pub(super) more: usize,
    pub(super) notes: Vec<Note>,
    /// The places of faults and what is allowed there: what a part says wrong, each of its instances would say again.
    seen: HashSet<(Place, String)>,
    noted: HashSet<(Place, String)>,
}

impl Log {
    pub(super) fn fault(&mut self, place: Place, found: impl Into<String>, allowed: impl Into<String>) {
        let allowed = allowed.into();
        if self.faults.len() >= KEPT {
            self.more += 1;
        } else if self.seen.insert((place, allowed.clone())) {
            self.faults.push(Raw { place, found: found.into(), allowed });
        }
    }

    /// Records that something is left out; it matters if a connector depends on it.
    pub(super) fn leave_out(&mut self, place: Place, what: impl Into<String>, matters: bool) {
        let what = what.into();
        if self.noted.insert((place, what.clone())) {
            self.notes.push(Note { place, what, matters });
        }
    }
}
