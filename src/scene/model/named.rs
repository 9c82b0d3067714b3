//! What a scene has by name.

use indexmap::IndexSet;
use std::ops::Index;

/// Things by name, in the order of the file, in which they are numbered.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Named<T> {
    names: IndexSet<Box<str>>,
    things: Vec<T>,
}

impl<T> Default for Named<T> {
    fn default() -> Self {
        Self { names: IndexSet::new(), things: Vec::new() }
    }
}

impl<T> Named<T> {
    /// As many as can be numbered in 32 bits, nodes beside orientations.
    const MOST: usize = 1 << 30;

    /// Adds one of a new name; gives it back if there is no number left.
    pub(in crate::scene) fn push(&mut self, name: &str, thing: T) -> Result<(), T> {
        if self.len() == Self::MOST {
            return Err(thing);
        }
        self.names.insert(name.into());
        self.things.push(thing);
        Ok(())
    }

    pub(in crate::scene) fn len(&self) -> usize {
        self.things.len()
    }

    /// The number that the next will have.
    pub(in crate::scene) fn next_number(&self) -> u32 {
        number(self.len())
    }

    pub(in crate::scene) fn number_of(&self, name: &str) -> Option<u32> {
        self.names.get_index_of(name).map(number)
    }

    pub(in crate::scene) fn name(&self, number: u32) -> &str {
        &self.names[number as usize]
    }

    pub(in crate::scene) fn names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.names.iter().map(|name| &**name)
    }

    pub(in crate::scene) fn things(&self) -> &[T] {
        &self.things
    }

    pub(in crate::scene) fn iter(&self) -> impl Iterator<Item = (&str, &T)> {
        self.names().zip(&self.things)
    }

    /// Each made into something else, or `None` if one of them cannot be.
    pub(in crate::scene) fn each<U>(self, make: impl FnMut(T) -> Option<U>) -> Option<Named<U>> {
        let things = self.things.into_iter().map(make).collect::<Option<_>>()?;
        Some(Named { names: self.names, things })
    }
}

impl<T> Index<u32> for Named<T> {
    type Output = T;

    fn index(&self, number: u32) -> &T {
        &self.things[number as usize]
    }
}

fn number(index: usize) -> u32 {
    u32::try_from(index).expect("no more are taken than can be numbered")
}
