//! Results of a state as rows of columns.

use super::Run;
use crate::element::table::{Number, Span};
use crate::scene::model::{Members, Named, SceneElement};
use indexmap::IndexMap;
use rayon::prelude::*;
use std::ops::Range;

/// The sources of the rows of every column.
#[derive(Debug)]
pub(in crate::scene) struct Gathered<'s> {
    /// First those of slide lines, then those of the other elements in the order of the file.
    pub(in crate::scene) columns: Vec<Gather<'s>>,
    /// For every result of the slide lines in turn: its column, and its index there.
    slid: Vec<[usize; 2]>,
}

/// The source of the rows of a column: an output of an element, of a set of elements, or of a slide line.
#[derive(Debug)]
pub(in crate::scene) struct Gather<'s> {
    pub(in crate::scene) name: &'s str,
    pub(in crate::scene) output: &'static str,
    /// The number of elements in a set; `None` if it is not a set.
    pub(in crate::scene) count: Option<usize>,
    /// The number of components of each.
    pub(in crate::scene) width: usize,
    /// Empty for sliding elements.
    pieces: Vec<Piece>,
}

impl Gather<'_> {
    /// The count of numbers along each axis: states; the elements of a set; components, if there are several.
    pub(in crate::scene) fn shape(&self, states: usize) -> Vec<usize> {
        let components = Some(self.width).filter(|&width| width > 1);
        [Some(states), self.count, components].into_iter().flatten().collect()
    }

    /// The name of the array in a file.
    pub(in crate::scene) fn array(&self) -> String {
        array_name(self.name, self.output)
    }
}

/// Elements of a set that are consecutive in a group.
#[derive(Clone, Debug)]
struct Piece {
    group: usize,
    places: Range<usize>,
    /// The index of the first of them in the set.
    member: usize,
    span: Span,
}

impl<'s, T: Number> Run<'s, T> {
    /// The sources of the rows of every column.
    pub(in crate::scene) fn gathered(&self) -> Gathered<'s> {
        let elements = &self.scene.elements;
        let mut sliding = IndexMap::new();
        let mut slid = Vec::new();
        for (line, contact) in self.contacts.iter().enumerate() {
            for (element, output, width) in contact.outputs() {
                let (thing, member) = element.map_or((None, 0), |number| {
                    let (thing, member) = elements.locate(number);
                    (Some(thing), member)
                });
                let entry = sliding.entry((line, thing, output));
                slid.push([entry.index(), member as usize]);
                entry.or_insert(width);
            }
        }
        let mut columns: Vec<_> = sliding
            .into_iter()
            .map(|((line, thing, output), width)| {
                let (name, count) = thing.map_or((self.contacts[line].name(), None), |thing| name_of(elements, thing));
                Gather { name, output, count, width, pieces: Vec::new() }
            })
            .collect();
        columns.extend(elements.iter().flat_map(|(name, members, _)| self.of_thing(name, members)));
        Gathered { columns, slid }
    }

    /// The columns of an element or a set of elements that does not slide.
    fn of_thing(&self, name: &'s str, members: Members) -> Vec<Gather<'s>> {
        let mut pieces: Vec<Piece> = Vec::new();
        let nowhere = Span { at: 0, len: 0 };
        for (member, number) in members.numbers().enumerate() {
            let Some([group, place]) = self.places[number as usize] else { return Vec::new() };
            let (group, place) = (group as usize, place as usize);
            match pieces.last_mut() {
                Some(last) if last.group == group && last.places.end == place => last.places.end += 1,
                _ => pieces.push(Piece { group, places: place..place + 1, member, span: nowhere }),
            }
        }
        let outputs = |piece: &Piece| &self.plan.groups[piece.group].recipe.outputs;
        let of_output = |(index, &(output, Span { len, .. })): (usize, &(&'static str, Span))| {
            // Every element of a kind has its outputs in the same order.
            let pieces = pieces.iter().map(|piece| Piece { span: outputs(piece)[index].1, ..piece.clone() });
            let count = members.count().map(|count| count as usize);
            Gather { name, output, count, width: len, pieces: pieces.collect() }
        };
        pieces.first().map(outputs).into_iter().flatten().enumerate().map(of_output).collect()
    }

    /// Copies the results of the current state to one row per column; NaN where a result does not exist.
    pub(in crate::scene) fn gather(&self, gathered: &Gathered<'_>, rows: &mut [&mut [f64]]) {
        let columns = rows.par_iter_mut().zip(&gathered.columns);
        columns.for_each(|(row, Gather { width, pieces, .. })| {
            for Piece { group, places, member, span } in pieces {
                let to = &mut row[member * width..][..places.len() * width];
                self.groups[*group].copy(&self.plan.groups[*group], places.clone(), *span, to);
            }
        });
        let mut slid = gathered.slid.iter();
        for contact in &self.contacts {
            contact.for_each_result(usize::MAX, &mut |_, _, components| {
                let Some(&[column, member]) = slid.next() else { return };
                let width = gathered.columns[column].width;
                let to = &mut rows[column][member * width..][..width];
                to.fill(f64::NAN);
                to.iter_mut().zip(components).for_each(|(to, component)| *to = component.rounded());
            });
        }
    }
}

/// The name of the array of an output in a file.
pub(in crate::scene) fn array_name(element: &str, output: &str) -> String {
    format!("{element}/{output}")
}

/// The name of an element or a set by its index, and the number of members in a set.
fn name_of(elements: &Named<SceneElement>, place: usize) -> (&str, Option<usize>) {
    let (name, members, _) = elements.nth(place);
    (name, members.count().map(|count| count as usize))
}
