//! Numbers that may be given in a file.

use crate::formula::quantity::Domain;
use crate::scene::json::{Read, Reader};

/// The content of a file where a number may be given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Given {
    Absent,
    /// Something else, for which a fault has been recorded.
    Faulty,
    Number(f64),
}

impl Given {
    pub(super) fn read(reader: &mut Reader, domain: Domain) -> Read<Self> {
        Ok(reader.number(domain)?.map_or(Self::Faulty, Self::Number))
    }

    /// The number, if there is one.
    pub(super) fn number(self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(number),
            Self::Absent | Self::Faulty => None,
        }
    }
}

/// An object of numbers, each in its domain; `None` if it is something else.
pub(super) fn numbers<const N: usize>(reader: &mut Reader, keys: [(&str, Domain); N]) -> Read<Option<[Given; N]>> {
    let mut given = [Given::Absent; N];
    let is_object = reader.record(&keys.map(|(name, _)| name), |reader, key| {
        given[key] = Given::read(reader, keys[key].1)?;
        Ok(())
    })?;
    Ok(is_object.then_some(given))
}

/// The number of entries that are present, faulty or not.
pub(super) fn count(given: &[Given]) -> usize {
    given.iter().filter(|&&given| given != Given::Absent).count()
}
