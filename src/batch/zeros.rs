//! Which entries of a Jacobian are zero everywhere.
//!
//! `zeros.txt` has a line for every formula of the catalog: its identifier, and a bit for each entry, output by output over
//! all inputs, four in a hexadecimal digit, the first the lowest. It is written by a test, `tests/graph.rs`, from what is
//! recorded of the formulas, and read by the compiler.

#![expect(clippy::inline_always, reason = "which entries are zero is known where a formula is compiled")]

use crate::formula::{Fields, Formula};

const TABLE: &[u8] = include_bytes!("zeros.txt");

/// The digits of this formula; of one that is not in the table, every entry counts.
const fn digits<F: Formula>() -> Option<&'static [u8]> {
    let (mut rest, id) = (TABLE, F::SPEC.id.as_bytes());
    while !rest.is_empty() {
        let (line, after) = rest.split_at(length_until(rest, b'\n'));
        let (name, digits) = line.split_at(length_until(line, b' '));
        if are_equal(name, id) {
            return Some(digits.split_at(1).1);
        }
        rest = after.split_at(1).1;
    }
    None
}

/// How many bytes stand before this one.
const fn length_until(text: &[u8], byte: u8) -> usize {
    let mut length = 0;
    while text[length] != byte {
        length += 1;
    }
    length
}

const fn are_equal(x: &[u8], y: &[u8]) -> bool {
    let (mut k, mut equal) = (0, x.len() == y.len());
    while equal && k < x.len() {
        equal = x[k] == y[k];
        k += 1;
    }
    equal
}

/// How many entries there are, zeros and all.
const fn all<F: Formula>() -> usize {
    F::Outputs::<f64>::LEN * F::Inputs::<f64>::LEN
}

/// Whether an entry is not zero everywhere; they are counted output by output over all inputs.
#[inline(always)]
pub(super) const fn is_entry<F: Formula>(k: usize) -> bool {
    match const { digits::<F>() } {
        Some(digits) => k / 4 < digits.len() && value_of(digits[k / 4]) >> (k % 4) & 1 == 1,
        None => true,
    }
}

#[inline(always)]
const fn value_of(digit: u8) -> u8 {
    match digit {
        b'0'..=b'9' => digit - b'0',
        _ => digit - b'a' + 10,
    }
}

/// How many entries are not zero everywhere.
pub(super) const fn entries<F: Formula>() -> usize {
    let (mut k, mut count) = (0, 0);
    while k < all::<F>() {
        count += is_entry::<F>(k) as usize;
        k += 1;
    }
    count
}
