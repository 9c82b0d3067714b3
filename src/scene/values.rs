//! The components of an output in every state, contiguous in memory.

use serde::{Serialize, Serializer};

/// The components of an output of an element, state by state.
///
/// Their number is the same in every state, or zero: a torque does not exist in every state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values {
    numbers: Vec<f64>,
    /// The number of components in a state that has any.
    width: usize,
    states: usize,
    /// The states without components, in ascending order.
    empty: Vec<usize>,
}

impl Values {
    /// Adds a state.
    ///
    /// # Panics
    /// If it has components, but not as many as an earlier state.
    pub(super) fn push(&mut self, components: impl ExactSizeIterator<Item = f64>) {
        if components.len() == 0 {
            self.empty.push(self.states);
        } else {
            assert!(self.numbers.is_empty() || components.len() == self.width, "an output keeps its components");
            self.width = components.len();
            self.numbers.extend(components);
        }
        self.states += 1;
    }

    /// The components in a state, counted from 0.
    pub fn get(&self, state: usize) -> Option<&[f64]> {
        if state >= self.states {
            return None;
        }
        match self.empty.binary_search(&state) {
            Ok(_) => Some(&[]),
            Err(before) => self.numbers.get((state - before) * self.width..(state - before + 1) * self.width),
        }
    }

    /// The components, state by state.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        (0..self.states).map(|state| self.get(state).unwrap_or_default())
    }

    /// The number of states.
    pub fn len(&self) -> usize {
        self.states
    }

    /// Whether there is no state.
    pub fn is_empty(&self) -> bool {
        self.states == 0
    }

    /// The number of components in a state that has any.
    pub fn width(&self) -> usize {
        self.width
    }

    /// All numbers, state after state.
    pub fn numbers(&self) -> &[f64] {
        &self.numbers
    }

    /// All numbers, state after state, for modification.
    pub fn numbers_mut(&mut self) -> &mut [f64] {
        &mut self.numbers
    }
}

/// A list per state.
impl Serialize for Values {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter())
    }
}

#[cfg(test)]
mod tests {
    use super::Values;

    #[test]
    fn a_state_without_components_stands_between_others() {
        let states: [&[f64]; 5] = [&[], &[1.0, 2.0], &[], &[], &[3.0, 4.0]];
        let mut values = Values::default();
        for state in states {
            values.push(state.iter().copied());
        }
        assert!(values.iter().eq(states));
        assert_eq!((values.get(4), values.get(3), values.get(5)), (Some(states[4]), Some(states[3]), None));
        assert_eq!((values.len(), values.width(), values.numbers()), (5, 2, &[1.0, 2.0, 3.0, 4.0][..]));
        assert_eq!((values.is_empty(), Values::default().is_empty()), (false, true));
        assert_eq!(serde_json::to_string(&values).unwrap(), "[[],[1.0,2.0],[],[],[3.0,4.0]]");
    }
}
