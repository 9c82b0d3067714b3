//! Which entries of a Jacobian are identically zero, and which formulas are computed for several rows together.
//!
//! `structure.txt` has a line for every formula of the catalog: its identifier and a bit for each entry, output by output over
//! all inputs, four per hexadecimal digit, lowest bit first; `-` if the Jacobian is automatic, so that every entry counts. For a
//! formula of simple operations and comparisons `straight` follows, or `guarded` if extreme numbers make a result NaN. The file
//! is written by the test `tests/graph.rs` from the recorded formulas, and read at compile time.

#![expect(clippy::inline_always, reason = "which entries are zero is known where a formula is compiled")]

use crate::formula::{Fields, Finite, Formula};

const TABLE: &[u8] = include_bytes!("structure.txt");

/// The text after the identifier of this formula; `None` if it is not in the table, in which case every entry counts.
const fn line<F: Formula>() -> Option<&'static [u8]> {
    let (mut rest, id) = (TABLE, F::SPEC.id.as_bytes());
    while !rest.is_empty() {
        let (line, after) = cut(rest, b'\n');
        let (name, behind) = cut(line, b' ');
        if are_equal(name, id) {
            return Some(behind);
        }
        rest = after;
    }
    None
}

const fn digits<F: Formula>() -> Option<&'static [u8]> {
    match line::<F>() {
        Some(line) => match cut(line, b' ').0 {
            b"-" => None,
            digits => Some(digits),
        },
        None => None,
    }
}

/// Whether several rows of a formula are computed together: either the inputs guarantee that nothing overflows, or all
/// results are checked.
pub(super) const fn is_straight<F: Formula>() -> bool {
    is_guarded::<F>() || has_word::<F>(b"straight") && !matches!(F::SPEC.finite, Finite::Unknown)
}

/// Whether several rows of a formula are computed together with all results checked: extreme numbers make one of them NaN.
pub(super) const fn is_guarded<F: Formula>() -> bool {
    has_word::<F>(b"guarded")
}

const fn has_word<F: Formula>(word: &[u8]) -> bool {
    match line::<F>() {
        Some(line) => are_equal(cut(line, b' ').1, word),
        None => false,
    }
}

/// The bytes before and after the first occurrence of `byte`; all of them before if there is none.
const fn cut(text: &[u8], byte: u8) -> (&[u8], &[u8]) {
    let mut length = 0;
    while length < text.len() {
        if text[length] == byte {
            let (before, rest) = text.split_at(length);
            return (before, rest.split_at(1).1);
        }
        length += 1;
    }
    (text, &[])
}

const fn are_equal(x: &[u8], y: &[u8]) -> bool {
    let (mut k, mut equal) = (0, x.len() == y.len());
    while equal && k < x.len() {
        equal = x[k] == y[k];
        k += 1;
    }
    equal
}

/// The number of entries, including zeros.
const fn all<F: Formula>() -> usize {
    F::Outputs::<f64>::LEN * F::Inputs::<f64>::LEN
}

/// Whether an entry is not identically zero; entries are counted output by output over all inputs.
#[inline(always)]
pub(super) const fn is_entry<F: Formula>(k: usize) -> bool {
    if const { entries::<F>() == all::<F>() } {
        return true;
    }
    let first = const { &first_bits::<F>() };
    if k / 64 < WORDS { first[k / 64] >> (k % 64) & 1 == 1 } else { is_digit::<F>(k) }
}

/// The number of words of 64 entries that are looked up in one step where the index is not known at compile time.
const WORDS: usize = 16;

/// A bit for each of the first entries.
const fn first_bits<F: Formula>() -> [u64; WORDS] {
    let (mut bits, mut k) = ([0; WORDS], 0);
    while k < 64 * WORDS {
        bits[k / 64] |= (is_digit::<F>(k) as u64) << (k % 64);
        k += 1;
    }
    bits
}

/// Whether an entry is not identically zero, according to the table.
const fn is_digit<F: Formula>(k: usize) -> bool {
    match const { digits::<F>() } {
        Some(digits) => k / 4 < digits.len() && value_of(digits[k / 4]) >> (k % 4) & 1 == 1,
        None => true,
    }
}

const fn value_of(digit: u8) -> u8 {
    match digit {
        b'0'..=b'9' => digit - b'0',
        _ => digit - b'a' + 10,
    }
}

/// The entries that are not identically zero.
pub(super) fn places<F: Formula>() -> impl Iterator<Item = usize> {
    (0..all::<F>()).filter(|&k| is_entry::<F>(k))
}

/// The number of entries that are not identically zero.
pub(super) const fn entries<F: Formula>() -> usize {
    let (mut k, mut count) = (0, 0);
    while k < all::<F>() {
        count += is_digit::<F>(k) as usize;
        k += 1;
    }
    count
}
