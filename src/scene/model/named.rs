//! The named entries of a scene.

use indexmap::IndexSet;
use std::fmt::{self, Write as _};
use std::ops::Index;

/// Entries by name, in the order of the file. An entry is a single item, or a set of many with one name; the members of all
/// entries are numbered consecutively.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Named<T> {
    names: IndexSet<Box<str>>,
    things: Vec<T>,
    /// The members of each entry.
    members: Vec<Members>,
    len: u32,
}

/// Members of one entry: all of them, or those selected by a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::scene) struct Members {
    first: u32,
    /// The step from one to the next; 0 for a single one that serves all.
    step: u32,
    /// The number of members; `None` if it is not a set.
    count: Option<u32>,
}

impl Members {
    fn one(first: u32) -> Self {
        Self { first, step: 0, count: None }
    }

    /// The number of members in a set; `None` if it is not a set.
    pub(in crate::scene) fn count(&self) -> Option<u32> {
        self.count
    }

    /// The number of members.
    pub(in crate::scene) fn len(&self) -> u32 {
        self.count.unwrap_or(1)
    }

    /// The number of a member by its index; if it is not a set, the same for every index.
    #[inline]
    pub(in crate::scene) fn number(&self, place: u32) -> u32 {
        self.first + self.step * place
    }

    /// The numbers of all members.
    pub(in crate::scene) fn numbers(self) -> impl ExactSizeIterator<Item = u32> {
        (0..self.len()).map(move |place| self.number(place))
    }

    /// The members of a set selected by the text between brackets, as in Python: `3`, `1:`, `:-1` or `::2`.
    fn select(&self, selection: &str) -> Option<Self> {
        let count = i64::from(self.count?);
        let place = |text: &str, absent: i64| {
            if text.is_empty() {
                return Some(absent);
            }
            let place: i64 = text.parse().ok()?;
            Some(if place < 0 { place + count } else { place })
        };
        let parts: Vec<_> = selection.split(':').collect();
        if let [one] = parts[..] {
            let at = u32::try_from(place(one, -1)?).ok().filter(|&at| i64::from(at) < count)?;
            return Some(Self::one(self.number(at)));
        }
        let [from, to, step] = [0, 1, 2].map(|part| parts.get(part).copied().unwrap_or_default());
        let step = if step.is_empty() { 1 } else { step.parse::<u32>().ok().filter(|&step| step > 0)? };
        let from = u32::try_from(place(from, 0)?.min(count)).ok()?;
        let to = u32::try_from(place(to, count)?.min(count)).ok()?;
        let selected = to.checked_sub(from).filter(|&selected| selected > 0 && parts.len() <= 3)?;
        Some(Self { first: self.number(from), step: self.step * step, count: Some(selected.div_ceil(step)) })
    }
}

/// The name of a member: that of its entry, and its index in a set.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::scene) struct Name<'n> {
    of: &'n str,
    place: Option<u32>,
}

impl Name<'_> {
    /// Appends it to a text.
    pub(in crate::scene) fn push_to(self, text: &mut String) {
        text.push_str(self.of);
        if let Some(place) = self.place {
            // Writing to a string cannot fail.
            let _ = write!(text, "[{place}]");
        }
    }
}

impl fmt::Display for Name<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.of)?;
        self.place.map_or(Ok(()), |place| write!(f, "[{place}]"))
    }
}

/// The name in quotes.
impl fmt::Debug for Name<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.to_string())
    }
}

impl<T> Default for Named<T> {
    fn default() -> Self {
        Self { names: IndexSet::new(), things: Vec::new(), members: Vec::new(), len: 0 }
    }
}

impl<T> Named<T> {
    /// The maximum that can be numbered in 32 bits, for nodes in addition to orientations.
    const MOST: u32 = 1 << 30;

    /// Adds an entry with a new name, or a set of `count` members; returns it if not enough numbers are left.
    pub(in crate::scene) fn push(&mut self, name: &str, count: Option<u32>, thing: T) -> Result<(), T> {
        let members = Members { first: self.len, step: u32::from(count.is_some()), count };
        if members.len() > Self::MOST - self.len {
            return Err(thing);
        }
        self.names.insert(name.into());
        self.things.push(thing);
        self.members.push(members);
        self.len += members.len();
        Ok(())
    }

    /// The number of members of all entries.
    pub(in crate::scene) fn len(&self) -> usize {
        self.len as usize
    }

    /// The number of the next member.
    pub(in crate::scene) fn next_number(&self) -> u32 {
        self.len
    }

    /// The members named by a reference: those of an entry, or the selected ones of a set, such as `b[3]` or `b[1:]`.
    pub(in crate::scene) fn members(&self, reference: &str) -> Option<Members> {
        if let Some(thing) = self.names.get_index_of(reference) {
            return Some(self.members[thing]);
        }
        let (name, selection) = reference.strip_suffix(']')?.split_once('[')?;
        self.members[self.names.get_index_of(name)?].select(selection)
    }

    /// The members of the entry with this name; the entry at `place` is tried first, since names mostly come in the order of the
    /// entries. Afterwards `place` is the index of the next entry.
    pub(in crate::scene) fn members_near(&self, place: &mut usize, name: &str) -> Option<Members> {
        if self.names.get_index(*place).is_none_or(|known| **known != *name) {
            *place = self.names.get_index_of(name)?;
        }
        *place += 1;
        Some(self.members[*place - 1])
    }

    /// Whether there is an entry with this name.
    pub(in crate::scene) fn knows(&self, name: &str) -> bool {
        self.names.contains(name)
    }

    /// The index of the entry to which this member belongs, and the index of the member in it.
    #[inline]
    pub(in crate::scene) fn locate(&self, number: u32) -> (usize, u32) {
        // Without sets, the index of an entry is its number.
        if self.things.len() == self.len() {
            return (number as usize, 0);
        }
        let thing = self.members.partition_point(|members| members.first <= number) - 1;
        (thing, number - self.members[thing].first)
    }

    /// The name of a member.
    pub(in crate::scene) fn name(&self, number: u32) -> Name<'_> {
        let (thing, place) = self.locate(number);
        Name { of: &self.names[thing], place: self.members[thing].count.map(|_| place) }
    }

    /// The names of the entries.
    pub(in crate::scene) fn names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.names.iter().map(|name| &**name)
    }

    pub(in crate::scene) fn things(&self) -> &[T] {
        &self.things
    }

    /// The entries with their names and members.
    pub(in crate::scene) fn iter(&self) -> impl Iterator<Item = (&str, Members, &T)> {
        self.names().zip(&self.members).zip(&self.things).map(|((name, &members), thing)| (name, members, thing))
    }

    /// The entry with this index, with its name and members.
    pub(in crate::scene) fn nth(&self, place: usize) -> (&str, Members, &T) {
        (&self.names[place], self.members[place], &self.things[place])
    }

    /// Converts every entry, or returns `None` if one of them cannot be converted.
    pub(in crate::scene) fn each<U>(self, make: impl FnMut(T) -> Option<U>) -> Option<Named<U>> {
        let Self { names, things, members, len } = self;
        let things = things.into_iter().map(make).collect::<Option<_>>()?;
        Some(Named { names, things, members, len })
    }
}

/// The entry to which this member belongs.
impl<T> Index<u32> for Named<T> {
    type Output = T;

    fn index(&self, number: u32) -> &T {
        &self.things[self.locate(number).0]
    }
}

#[cfg(test)]
mod tests {
    use super::Named;

    fn named() -> Named<&'static str> {
        let mut named = Named::default();
        for (name, count) in [("a", None), ("b", Some(5)), ("c[1]", None), ("d", Some(1))] {
            named.push(name, count, name).unwrap();
        }
        named
    }

    #[test]
    fn members_are_numbered_through() {
        let named = named();
        assert_eq!(named.len(), 8);
        let names: Vec<_> = (0..8).map(|number| named.name(number).to_string()).collect();
        assert_eq!(names, ["a", "b[0]", "b[1]", "b[2]", "b[3]", "b[4]", "c[1]", "d[0]"]);
        let alone =
            |name: &String| named.members(name).filter(|members| members.count().is_none()).map(|one| one.number(0));
        assert!((0..8).all(|number| alone(&names[number as usize]) == Some(number)));
        assert_eq!([0, 5, 6].map(|number| named[number]), ["a", "b", "c[1]"]);
    }

    #[test]
    fn sets_are_selected_from_as_in_python() {
        let named = named();
        let numbers = |reference: &str| named.members(reference).map(|members| members.numbers().collect::<Vec<_>>());
        for (reference, expected) in [
            ("a", &[0][..]),
            ("b", &[1, 2, 3, 4, 5]),
            ("b[:]", &[1, 2, 3, 4, 5]),
            ("b[1:]", &[2, 3, 4, 5]),
            ("b[:-1]", &[1, 2, 3, 4]),
            ("b[1:-1:2]", &[2, 4]),
            ("b[::3]", &[1, 4]),
            ("b[2:99]", &[3, 4, 5]),
            ("b[-1]", &[5]),
            ("d[0]", &[7]),
        ] {
            assert_eq!(numbers(reference).as_deref(), Some(expected), "{reference}");
        }
        let none = ["b[5]", "b[-6]", "b[]", "b[3:3]", "b[4:2]", "b[::0]", "b[::-1]", "b[1:2:1:1]", "b[x]", "b[0][0]"];
        for reference in none.into_iter().chain(["a[0]", "a[:]", "c", "[0]", "b[", "b]", "b[-9:]"]) {
            assert_eq!(numbers(reference), None, "{reference}");
        }
    }

    #[test]
    fn no_more_are_taken_than_can_be_numbered() {
        let most = Named::<()>::MOST;
        let mut named = Named::default();
        named.push("one", None, ()).unwrap();
        assert!(named.push("too many", Some(most), ()).is_err());
        named.push("the rest", Some(most - 1), ()).unwrap();
        assert!(named.push("one more", None, ()).is_err());
        assert_eq!((named.next_number(), named.names().len()), (most, 2));
    }

    #[test]
    fn names_that_come_out_of_order_are_found_all_the_same() {
        let named = named();
        let mut place = 0;
        let mut near = |name: &str| {
            let number = named.members_near(&mut place, name).map(|members| members.number(0));
            (number, place)
        };
        assert_eq!(["a", "b", "d", "a"].map(&mut near), [(Some(0), 1), (Some(1), 2), (Some(7), 4), (Some(0), 1)]);
        assert_eq!([near("x"), near("b"), near("c[1]")], [(None, 1), (Some(1), 2), (Some(6), 3)]);
    }
}
