//! The history of a scene as columns: frames whose values are arrays over all states.

use super::columns::{Columns, Reference};
use super::frames::{Mentions, check_own, check_sliding, motions};
use super::keys;
use crate::formula::quantity::Domain;
use crate::scene::json::{Mark, Read, Reader};
use crate::scene::kind::Dimension;
use crate::scene::model::{Components, History, HistoryColumn, HistoryColumns, OpenColumn, Places, Quantity};
use crate::scene::npz::{Archive, Array, Unfit};
use rayon::prelude::*;
use std::sync::Arc;

/// A column, and the position at which the scene names it.
struct Wanted {
    column: HistoryColumn,
    mark: Mark,
}

/// Reads frames in which every value is an array of the file.
pub(super) fn history_of(
    reader: &mut Reader,
    mentions: &mut Mentions,
    columns: &Columns,
    file: &Arc<Archive>,
) -> Read<History> {
    let place = reader.place();
    let (mut time, mut wanted, mut given) = (None, Vec::new(), false);
    let keys = if mentions.sliding() { &keys::SLIDING_FRAME } else { &keys::FRAME };
    let dimension = mentions.dimension;
    let mut want = |reader: &mut Reader, of, quantity, domain| {
        let Some(Reference { name: array, mark }) = array_of(reader, columns)? else { return Ok(()) };
        let (path, components, places) = (mark.path.clone(), components(quantity, dimension), Places::From(0));
        let column = HistoryColumn { array, path, quantity, domain, components, of, places };
        wanted.push(Wanted { column, mark });
        Ok(())
    };
    reader.record(keys, |reader, key| match key {
        0 => {
            given = true;
            time = array_of(reader, columns)?;
            Ok(())
        }
        1 => mentions.moved.each(reader, 0, |reader, of, place| {
            check_own(reader, place, mentions.pressed.known, of);
            reader.record(motions(dimension), |reader, key| {
                want(reader, of, [Quantity::Moves, Quantity::Turns][key], Domain::Real)
            })?;
            Ok(())
        }),
        _ if dimension == Dimension::Axisymmetric => mentions.pressed.each(reader, 0, |reader, of, place| {
            check_sliding(reader, place, &mentions.slides, of);
            want(reader, of, Quantity::Pressures, Domain::NonNegative)
        }),
        _ => {
            let elements = mentions.loaded.known;
            mentions.loaded.each(reader, 0, |reader, of, _| {
                let Some(kind) = elements[of.number(0)].kind() else { return reader.skip() };
                let names: Vec<_> = kind.loads().collect();
                reader.record(&names, |reader, key| want(reader, of, Quantity::Loads(key), kind.domain(names[key])))?;
                Ok(())
            })
        }
    })?;
    if !given {
        reader.fault(place, "frames without \"time\"", "frames with the array of their times");
    }
    let times = time.and_then(|time| columns.load(reader, time, times));
    // Without times the number of states is unknown.
    Ok(times.map_or_else(|| History::Frames(Vec::new()), |times| checked(reader, file, times, wanted)))
}

/// The components of a value that the array of a quantity provides: in the plane, nodes move and rotate within it.
fn components(quantity: Quantity, dimension: Dimension) -> Components {
    let in_space = dimension == Dimension::Space;
    match quantity {
        Quantity::Moves => Components { first: 0, count: dimension.coordinates() },
        Quantity::Turns if in_space => Components { first: 0, count: 3 },
        Quantity::Turns => Components { first: 2, count: 1 },
        Quantity::Pressures | Quantity::Loads(_) => Components { first: 0, count: 1 },
    }
}

/// The name of an array, which must be next in the text.
fn array_of(reader: &mut Reader, columns: &Columns) -> Read<Option<Reference>> {
    match columns.refer(reader)? {
        Some(array) => Ok(Some(array)),
        // Anything else is a fault.
        None => reader.string("the name of an array").map(|_| None),
    }
}

/// The times of the states.
fn times(mut array: Array) -> Result<Vec<f64>, Unfit> {
    if !matches!(*array.outline().shape(), [states] if states > 0) {
        return Err(array.outline().misshapen("(n,): states, at least one"));
    }
    let times = array.numbers(Domain::Real)?;
    match times.windows(2).position(|pair| pair[1] < pair[0]) {
        Some(before) => {
            let allowed = format!("times that do not fall, here at least {:?}", times[before]);
            Err(array.outline().wrong(times[before + 1], before + 1, allowed))
        }
        None => Ok(times),
    }
}

/// Checks all arrays, on all cores.
fn checked(reader: &mut Reader, file: &Arc<Archive>, times: Vec<f64>, wanted: Vec<Wanted>) -> History {
    let states = times.len();
    let check = |wanted: &Wanted| {
        let mut open = OpenColumn::new(&wanted.column, file, states)?;
        (0..states).try_for_each(|_| open.advance(|_, _| ()))
    };
    let checks: Vec<_> = wanted.par_iter().map(check).collect();
    let mut columns = Vec::new();
    for (Wanted { mark, column }, check) in wanted.into_iter().zip(checks) {
        match check {
            Ok(()) => columns.push(column),
            Err(Unfit { found, allowed }) => reader.fault_at(mark, found, allowed),
        }
    }
    History::Columns(HistoryColumns::new(Arc::clone(file), times, columns, reader.angles))
}
