//! Which entries of a Jacobian are zero everywhere, and of which formulas several rows are computed together.
//!
//! `structure.txt` has a line for every formula of the catalog: its identifier, and a bit for each entry, output by output over
//! all inputs, four in a hexadecimal digit, the first the lowest; `-` where the Jacobian is automatic, and every entry counts. A formula of simple operations and comparisons has `straight` after
//! it, or `guarded` where an extreme number makes a result NaN. The file is written by a test, `tests/graph.rs`, from what is recorded
//! of the formulas, and read by the compiler.

#![expect(clippy::inline_always, reason = "which entries are zero is known where a formula is compiled")]

use crate::formula::{Fields, Finite, Formula};

const TABLE: &[u8] = include_bytes!("structure.txt");

/// What stands behind the identifier of this formula; of one that is not in the table, every entry counts.
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

/// Whether several rows of a formula are computed together: inputs tell that nothing overflows, or all results are looked at.
pub(super) const fn is_straight<F: Formula>() -> bool {
    is_guarded::<F>() || has_word::<F>(b"straight") && !matches!(F::SPEC.finite, Finite::Unknown)
}

/// Whether several rows of a formula are computed together, and all results looked at: where one is extreme, one of them is NaN.
pub(super) const fn is_guarded<F: Formula>() -> bool {
    has_word::<F>(b"guarded")
}

const fn has_word<F: Formula>(word: &[u8]) -> bool {
    match line::<F>() {
        Some(line) => are_equal(cut(line, b' ').1, word),
        None => false,
    }
}

/// What stands before and after the first of these bytes; all of it before, if there is none.
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

/// How many entries there are, zeros and all.
const fn all<F: Formula>() -> usize {
    F::Outputs::<f64>::LEN * F::Inputs::<f64>::LEN
}

/// Whether an entry is not zero everywhere; they are counted output by output over all inputs.
#[inline(always)]
pub(super) const fn is_entry<F: Formula>(k: usize) -> bool {
    if const { entries::<F>() == all::<F>() } {
        return true;
    }
    let first = const { &first_bits::<F>() };
    if k / 64 < WORDS { first[k / 64] >> (k % 64) & 1 == 1 } else { is_digit::<F>(k) }
}

/// So many entries, 64 to each, are looked up in one step where the compiler does not know which it is.
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

/// Whether an entry is not zero everywhere, as the table says.
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

/// The entries that are not zero everywhere.
pub(super) fn places<F: Formula>() -> impl Iterator<Item = usize> {
    (0..all::<F>()).filter(|&k| is_entry::<F>(k))
}

/// How many entries are not zero everywhere.
pub(super) const fn entries<F: Formula>() -> usize {
    let (mut k, mut count) = (0, 0);
    while k < all::<F>() {
        count += is_digit::<F>(k) as usize;
        k += 1;
    }
    count
}
