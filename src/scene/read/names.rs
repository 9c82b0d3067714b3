//! Names chosen by the author, and references to them.

use crate::scene::json::{Read, Reader, Stop, some_of};
use crate::scene::model::{Members, Named};

/// The members of an object whose keys are names, each once. A faulty entry may still have a name, to
/// which others can refer without another fault; if there are no names at all, nothing that could refer to them is read.
pub(super) fn named<'t, T>(
    reader: &mut Reader<'t>,
    mut item: impl FnMut(&mut Reader<'t>) -> Read<T>,
) -> Read<Named<T>> {
    named_sets(reader, |reader, _| Ok((None, item(reader)?)))
}

/// The same if an entry may be a set with a number of members; `item` receives those above.
pub(super) fn named_sets<'t, T>(
    reader: &mut Reader<'t>,
    mut item: impl FnMut(&mut Reader<'t>, &Named<T>) -> Read<(Option<u32>, T)>,
) -> Read<Named<T>> {
    let mut all = Named::default();
    let is_object = reader.object("an object of named entries", |reader, name, place| {
        if name.is_empty() {
            reader.fault(place, "an empty name", "a name");
        }
        let (count, value) = item(reader, &all)?;
        if all.knows(name) {
            reader.fault(place, format!("{name:?} for the second time"), "each name once");
        } else if all.push(name, count, value).is_err() {
            reader.fault(place, format!("{} entries and one more", all.len()), "no more than can be numbered");
        }
        Ok(())
    })?;
    if is_object { Ok(all) } else { Err(Stop) }
}

/// An array of names that must be known, with the members of those that are.
pub(super) fn refer_all<T>(
    reader: &mut Reader,
    known: &Named<T>,
    allowed: &str,
    what: &str,
) -> Read<Option<Vec<Option<Members>>>> {
    let mut found = Vec::new();
    let is_array = reader.array(allowed, |reader, _| {
        let place = reader.place();
        let name = reader.string(format_args!("the name of a {what}"))?;
        found.push(name.and_then(|name| look_up_all(reader, known, place, &name, what)));
        Ok(())
    })?;
    Ok(is_array.then_some(found))
}

/// A name that must be known, with its number if it is.
pub(super) fn refer<T>(reader: &mut Reader, known: &Named<T>, what: &str) -> Read<Option<u32>> {
    let place = reader.place();
    let name = reader.string(format_args!("the name of a {what}"))?;
    Ok(name.and_then(|name| look_up(reader, known, place, &name, what)))
}

/// The number of a known name that is not a set.
pub(super) fn look_up<T>(reader: &mut Reader, known: &Named<T>, place: usize, name: &str, what: &str) -> Option<u32> {
    let members = look_up_all(reader, known, place, name, what)?;
    if members.count().is_some() {
        reader.fault(place, format!("{name:?}, a set"), format!("the name of one {what}"));
        return None;
    }
    Some(members.number(0))
}

/// The members of a known name.
pub(super) fn look_up_all<T>(
    reader: &mut Reader,
    known: &Named<T>,
    place: usize,
    name: &str,
    what: &str,
) -> Option<Members> {
    let members = known.members(name);
    if members.is_none() {
        let names = some_of(known.names());
        let allowed = if names.is_empty() { format!("no {what}, there are none") } else { format!("one of {names}") };
        reader.fault(place, format!("no {what} {name:?}"), allowed);
    }
    members
}
