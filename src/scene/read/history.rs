//! The history of a scene as columns: frames whose values are arrays over all states.

use super::columns::{Columns, Reference};
use super::frames::{Mentions, check_sliding, in_plane, motions};
use super::keys;
use crate::quantity::Domain;
use crate::scene::json::{Read, Reader};
use crate::scene::kind::Dimension;
use crate::scene::model::{Changes, Frame, Members};
use crate::scene::npz::{Array, Unfit};
use bytemuck::Pod;
use rayon::prelude::*;
use std::sync::Arc;

/// What an array changes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Quantity {
    Moves,
    Turns,
    /// By the place of the load in its kind.
    Loads(usize),
    Pressures,
}

/// An array that is wanted: its first axis are the states, its next the nodes or elements of a set.
struct Wanted {
    array: Reference,
    quantity: Quantity,
    of: Members,
    domain: Domain,
}

/// The values of nodes or elements, state by state.
enum Values {
    Vectors(Vec<Vec<[f64; 3]>>),
    Numbers(Vec<Vec<f64>>),
}

/// Reads frames of which every value is an array.
pub(super) fn history_of(reader: &mut Reader, mentions: &mut Mentions, columns: &Columns) -> Read<Vec<Frame>> {
    let place = reader.place();
    let (mut time, mut wanted, mut given) = (None, Vec::new(), false);
    let keys = if mentions.sliding() { &keys::SLIDING_FRAME } else { &keys::FRAME };
    let dimension = mentions.dimension;
    reader.record(keys, |reader, key| match key {
        0 => {
            given = true;
            time = array_of(reader, columns)?;
            Ok(())
        }
        1 => mentions.moved.each(reader, 0, |reader, of, _| {
            reader.record(motions(dimension), |reader, key| {
                let quantity = [Quantity::Moves, Quantity::Turns][key];
                let array = array_of(reader, columns)?;
                wanted.extend(array.map(|array| Wanted { array, quantity, of, domain: Domain::Real }));
                Ok(())
            })?;
            Ok(())
        }),
        _ if dimension == Dimension::Axisymmetric => mentions.pressed.each(reader, 0, |reader, of, place| {
            check_sliding(reader, place, &mentions.slides, of);
            let array = array_of(reader, columns)?;
            let (quantity, domain) = (Quantity::Pressures, Domain::NonNegative);
            wanted.extend(array.map(|array| Wanted { array, quantity, of, domain }));
            Ok(())
        }),
        _ => {
            let elements = mentions.loaded.known;
            mentions.loaded.each(reader, 0, |reader, of, _| {
                let Some(kind) = elements[of.number(0)].kind() else { return reader.skip() };
                let names: Vec<_> = kind.loads().collect();
                reader.record(&names, |reader, key| {
                    let (quantity, domain) = (Quantity::Loads(key), kind.domain(names[key]));
                    let array = array_of(reader, columns)?;
                    wanted.extend(array.map(|array| Wanted { array, quantity, of, domain }));
                    Ok(())
                })?;
                Ok(())
            })
        }
    })?;
    if !given {
        reader.fault(place, "frames without \"time\"", "frames with the array of their times");
    }
    let times = time.and_then(|time| columns.load(reader, time, times));
    let Some(times) = times else { return Ok(Vec::new()) };
    Ok(load(reader, dimension, columns, times, wanted))
}

/// The name of an array, which must stand next.
fn array_of(reader: &mut Reader, columns: &Columns) -> Read<Option<Reference>> {
    match columns.refer(reader)? {
        Some(array) => Ok(Some(array)),
        // Something else, which is a fault.
        None => reader.string("the name of an array").map(|_| None),
    }
}

/// The times of the states.
fn times(mut array: Array) -> Result<Vec<f64>, Unfit> {
    if !matches!(*array.outline().shape(), [states] if states > 0) {
        return Err(array.outline().misshapen("(n,): states, at least one"));
    }
    let times = array.numbers()?;
    match times.windows(2).position(|pair| pair[1] <= pair[0]) {
        Some(before) => {
            let allowed = format!("times after those before, here {:?}", times[before]);
            Err(array.outline().wrong(times[before + 1], before + 1, allowed))
        }
        None => Ok(times),
    }
}

/// Reads all arrays, on all cores, and makes frames of them.
fn load(
    reader: &mut Reader,
    dimension: Dimension,
    columns: &Columns,
    times: Vec<f64>,
    wanted: Vec<Wanted>,
) -> Vec<Frame> {
    let states = times.len();
    let read = |wanted: &Wanted| wanted.read(dimension, columns, states);
    let read: Vec<_> = wanted.par_iter().map(read).collect();
    let mut frames: Vec<_> = times.into_iter().map(|time| Frame { time, ..Frame::default() }).collect();
    let mut all = Vec::new();
    for (Wanted { array, quantity, of, .. }, values) in wanted.into_iter().zip(read) {
        match values {
            Ok(values) => all.push((quantity, of, values)),
            Err(Unfit { found, allowed }) => reader.fault_at(array.mark, found, allowed),
        }
    }
    while let Some(&(quantity, ..)) = all.first() {
        let of_quantity = all.extract_if(.., |(other, ..)| *other == quantity);
        let (mut vectors, mut numbers) = (Vec::new(), Vec::new());
        for (_, of, values) in of_quantity {
            match values {
                Values::Vectors(values) => vectors.push((of, values)),
                Values::Numbers(values) => numbers.push((of, values)),
            }
        }
        match quantity {
            Quantity::Moves => set(&mut frames, vectors, |frame| &mut frame.moves),
            Quantity::Turns => set(&mut frames, vectors, |frame| &mut frame.turns),
            Quantity::Pressures => set(&mut frames, numbers, |frame| &mut frame.pressures),
            Quantity::Loads(load) => set(&mut frames, numbers, |frame| {
                if frame.loads.len() <= load {
                    frame.loads.resize_with(load + 1, Changes::default);
                }
                &mut frame.loads[load]
            }),
        }
    }
    frames
}

/// Gives every frame its values of a quantity, of all nodes or elements that some array changes.
fn set<V: Copy>(
    frames: &mut [Frame],
    columns: Vec<(Members, Vec<Vec<V>>)>,
    changes: impl Fn(&mut Frame) -> &mut Changes<V>,
) {
    let mut of: Vec<u32> = columns.iter().flat_map(|(of, _)| of.numbers()).collect();
    let is_sorted = of.is_sorted();
    let mut order: Vec<usize> = Vec::new();
    if !is_sorted {
        order.extend(0..of.len());
        order.sort_unstable_by_key(|&place| of[place]);
        of.sort_unstable();
    }
    let of: Arc<[u32]> = of.into();
    let mut columns: Vec<_> = columns.into_iter().map(|(_, states)| states.into_iter()).collect();
    for frame in frames {
        let mut parts = columns.iter_mut().filter_map(Iterator::next);
        let mut to = parts.next().unwrap_or_default();
        parts.for_each(|part| to.extend(part));
        if !is_sorted {
            to = order.iter().map(|&place| to[place]).collect();
        }
        *changes(frame) = Changes { of: Arc::clone(&of), to };
    }
}

impl Wanted {
    fn read(&self, dimension: Dimension, columns: &Columns, states: usize) -> Result<Values, Unfit> {
        let array = columns.open(&self.array.name)?;
        let in_space = dimension == Dimension::Space;
        Ok(match self.quantity {
            Quantity::Moves if !in_space => {
                let in_plane = |[x, y]: [f64; 2]| [x, y, 0.0];
                Values::Vectors(each(self.states(array, states)?, in_plane))
            }
            Quantity::Turns if !in_space => Values::Vectors(each(self.states(array, states)?, in_plane)),
            Quantity::Moves | Quantity::Turns => Values::Vectors(self.states(array, states)?),
            Quantity::Loads(_) | Quantity::Pressures => Values::Numbers(self.states(array, states)?),
        })
    }

    /// The values of every state, whose components stand next to each other.
    fn states<V: Pod>(&self, mut array: Array, states: usize) -> Result<Vec<Vec<V>>, Unfit> {
        let components = size_of::<V>() / size_of::<f64>();
        let count = self.of.count().map(|count| count as usize);
        let width = Some(components).filter(|&components| components > 1);
        let shape: Vec<_> = [Some(states), count, width].into_iter().flatten().collect();
        let axes = [Some("states"), count.map(|_| "members"), width.map(|_| "components")];
        array.outline().expect(&shape, &axes.into_iter().flatten().collect::<Vec<_>>().join(", "))?;
        let len = self.of.len() as usize;
        let mut all = Vec::with_capacity(states);
        for state in 0..states {
            let mut values = vec![V::zeroed(); len];
            let numbers: &mut [f64] = bytemuck::cast_slice_mut(&mut values);
            array.fill(numbers)?;
            if self.domain != Domain::Real
                && let Some(place) = numbers.iter().position(|&number| !self.domain.allows(number))
            {
                let at = state * len * components + place;
                return Err(array.outline().wrong(numbers[place], at, self.domain.allowed()));
            }
            all.push(values);
        }
        array.finish()?;
        Ok(all)
    }
}

/// Every value made into another.
fn each<A, B>(states: Vec<Vec<A>>, make: impl Fn(A) -> B + Copy) -> Vec<Vec<B>> {
    states.into_iter().map(|values| values.into_iter().map(make).collect()).collect()
}
