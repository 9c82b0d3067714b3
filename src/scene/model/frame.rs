//! A state of a history: the changes from the previous state.

use super::named::Members;
use std::ops::Range;
use std::sync::Arc;

/// A state: the changes from the previous state. Everything else remains unchanged.
#[derive(Clone, Debug, Default)]
pub(in crate::scene) struct Frame {
    pub(in crate::scene) time: f64,
    /// Displacements of nodes from their initial positions.
    pub(in crate::scene) moves: Changes<[f64; 3]>,
    /// Rotation vectors of nodes from their initial orientations.
    pub(in crate::scene) turns: Changes<[f64; 3]>,
    /// Loads of elements, in the order of [`Kind::loads`].
    pub(in crate::scene) loads: Vec<Changes<f64>>,
    /// Pressures of hard contact of nodes on slide lines.
    pub(in crate::scene) pressures: Changes<f64>,
}

/// The quantities that change from state to state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::scene) enum Quantity {
    Moves,
    Turns,
    Pressures,
    /// A load, by its index in its kind.
    Loads(usize),
}

impl Quantity {
    /// Its index among all quantities.
    pub(in crate::scene) fn place(self) -> usize {
        match self {
            Self::Moves => 0,
            Self::Turns => 1,
            Self::Pressures => 2,
            Self::Loads(load) => 3 + load,
        }
    }
}

impl Frame {
    /// The nodes or elements that change.
    pub(in crate::scene) fn of_mut(&mut self, quantity: Quantity) -> &mut Arc<[u32]> {
        match quantity {
            Quantity::Moves => &mut self.moves.of,
            Quantity::Turns => &mut self.turns.of,
            Quantity::Pressures => &mut self.pressures.of,
            Quantity::Loads(load) => &mut self.load_mut(load).of,
        }
    }

    /// The nodes or elements that change, for every quantity that changes at all.
    pub(in crate::scene) fn changed(&self) -> impl Iterator<Item = (Quantity, &[u32])> {
        let Self { moves, turns, loads, pressures, .. } = self;
        let of_nodes =
            [(Quantity::Moves, &moves.of), (Quantity::Turns, &turns.of), (Quantity::Pressures, &pressures.of)];
        let of_elements = loads.iter().enumerate().map(|(load, changes)| (Quantity::Loads(load), &changes.of));
        of_nodes.into_iter().chain(of_elements).map(|(quantity, of)| (quantity, &**of)).filter(|(_, of)| !of.is_empty())
    }

    /// Adds the changes of a frame of the same state about other quantities.
    pub(in crate::scene) fn add(&mut self, other: Self) {
        let Self { time: _, moves, turns, loads, pressures } = other;
        if !moves.of.is_empty() {
            self.moves = moves;
        }
        if !turns.of.is_empty() {
            self.turns = turns;
        }
        if !loads.is_empty() {
            self.loads = loads;
        }
        if !pressures.of.is_empty() {
            self.pressures = pressures;
        }
    }

    /// A load, by its index in its kind.
    fn load_mut(&mut self, load: usize) -> &mut Changes<f64> {
        if self.loads.len() <= load {
            self.loads.resize_with(load + 1, Changes::default);
        }
        &mut self.loads[load]
    }

    /// The same with a 0 for every value.
    pub(in crate::scene) fn zeroed(&self) -> Self {
        let Self { time, moves, turns, loads, pressures } = self;
        let loads = loads.iter().map(Changes::zeroed).collect();
        Self { time: *time, moves: moves.zeroed(), turns: turns.zeroed(), loads, pressures: pressures.zeroed() }
    }

    /// The number of bytes of all values.
    pub(in crate::scene) fn bytes(&self) -> usize {
        let Self { moves, turns, loads, pressures, .. } = self;
        let vectors = size_of_val(&*moves.to) + size_of_val(&*turns.to);
        vectors + loads.iter().chain([pressures]).map(|changes| size_of_val(&*changes.to)).sum::<usize>()
    }

    /// The numbers of all values, for each [`Quantity`] by its index, and the count of numbers in a value.
    pub(in crate::scene) fn numbers_mut(&mut self) -> impl Iterator<Item = (&mut [f64], usize)> {
        let Self { moves, turns, loads, pressures, .. } = self;
        let vectors = [moves, turns].map(|changes| (changes.to.as_flattened_mut(), 3));
        let numbers = std::iter::once(pressures).chain(loads).map(|changes| (&mut *changes.to, 1));
        vectors.into_iter().chain(numbers)
    }
}

/// New values of some nodes or elements: their numbers, each once and in ascending order, and their values.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Changes<V> {
    /// States that change the same nodes or elements share it.
    pub(in crate::scene) of: Arc<[u32]>,
    pub(in crate::scene) to: Vec<V>,
}

impl<V> Default for Changes<V> {
    fn default() -> Self {
        Self { of: Arc::default(), to: Vec::new() }
    }
}

impl<V: bytemuck::Zeroable + Clone> Changes<V> {
    /// The same with a 0 for every value.
    fn zeroed(&self) -> Self {
        Self { of: Arc::clone(&self.of), to: vec![V::zeroed(); self.of.len()] }
    }
}

impl<V: Copy> Changes<V> {
    /// The changes at these indices.
    pub(in crate::scene) fn iter(&self, places: Range<usize>) -> impl Iterator<Item = (u32, V)> {
        self.of[places.clone()].iter().copied().zip(self.to[places].iter().copied())
    }

    /// The first index, not before `from`, whose node or element is this one or a later one.
    pub(in crate::scene) fn place(&self, from: usize, of: u32) -> usize {
        from + self.of[from..].partition_point(|&other| other < of)
    }

    /// The value of one node or element.
    pub(in crate::scene) fn get(&self, of: u32) -> Option<V> {
        let place = self.place(0, of);
        (self.of.get(place) == Some(&of)).then(|| self.to[place])
    }
}

/// Changes in any order.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Unsorted<V> {
    of: Vec<u32>,
    to: Vec<V>,
}

impl<V> Default for Unsorted<V> {
    fn default() -> Self {
        Self { of: Vec::new(), to: Vec::new() }
    }
}

impl<V: Copy> Unsorted<V> {
    /// Adds nodes or elements with one new value for all.
    pub(in crate::scene) fn push_all(&mut self, of: Members, to: V) {
        self.of.extend(of.numbers());
        self.to.resize(self.of.len(), to);
    }

    /// The changes sorted by node or element.
    pub(in crate::scene) fn sorted(self) -> Changes<V> {
        let Self { mut of, mut to } = self;
        if !of.is_sorted() {
            let mut changes: Vec<_> = of.into_iter().zip(to).collect();
            changes.sort_unstable_by_key(|&(of, _)| of);
            (of, to) = changes.into_iter().unzip();
        }
        Changes { of: of.into(), to }
    }
}
