//! The requested outputs.

use crate::scene::abaqus::{meant, own_name};
use crate::scene::json::{Read, Reader};
use crate::scene::kind::{Dimension, Kind};

/// Outputs requested of all elements that have them, each with its position in the text.
#[derive(Debug, Default)]
pub(super) struct Outputs(Vec<(String, usize)>);

impl Outputs {
    pub(super) fn read(reader: &mut Reader, dimension: Dimension) -> Read<Self> {
        let kinds: Vec<_> = Kind::all().filter(|kind| kind.dimension == dimension).collect();
        let mut known: Vec<_> = kinds.iter().flat_map(|kind| kind.outputs().map(|(name, _)| name)).collect();
        known.sort_unstable();
        known.dedup();
        Self::of(reader, &known)
    }

    /// The outputs of an element of this kind: one bit per output.
    pub(super) fn of_element(reader: &mut Reader, kind: &Kind) -> Read<u64> {
        let known: Vec<_> = kind.outputs().map(|(name, _)| name).collect();
        Ok(Self::of(reader, &known)?.mask(kind))
    }

    fn of(reader: &mut Reader, known: &[&str]) -> Read<Self> {
        let mut all: Vec<(String, usize)> = Vec::new();
        reader.array("an array of output names", |reader, _| {
            let place = reader.place();
            let Some(name) = reader.string("the name of an output")? else { return Ok(()) };
            let own = own_name(&name);
            if !known.contains(&own) {
                let hint = meant(&name, known).map(|meant| format!(" (did you mean {meant}?)")).unwrap_or_default();
                reader.fault(place, format!("no output {name:?}{hint}"), format!("one of {}", known.join(", ")));
            } else if all.iter().any(|(other, _)| *other == own) {
                reader.fault(place, format!("{name:?} for the second time"), "each output once");
            } else {
                all.push((own.into(), place));
            }
            Ok(())
        })?;
        Ok(Self(all))
    }

    /// One bit per output of the kind.
    pub(super) fn mask(&self, kind: &Kind) -> u64 {
        let wanted = |name: &str| self.0.iter().any(|(output, _)| output == name);
        let bits = kind.outputs().enumerate().filter(|(_, (name, _))| wanted(name));
        bits.fold(0, |mask, (bit, _)| mask | 1 << bit)
    }

    /// Reports the outputs that none of these kinds has.
    pub(super) fn check(&self, reader: &mut Reader, kinds: &[&Kind]) {
        for (name, place) in self.0.iter().filter(|(name, _)| !kinds.iter().any(|kind| kind.output(name).is_some())) {
            let found = format!("output {name:?}, which no element here has");
            reader.fault(*place, found, "an output of one of the elements");
        }
    }
}
