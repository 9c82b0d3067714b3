//! Permuted numbers.

use super::sample::Evidence;
use crate::question::Wanted;
use jointproof::formula::Field;

/// The source of each number of an answer.
type Places = Vec<usize>;

/// All permutations with a name; one that moves nothing explains nothing.
pub(super) fn exchanges(evidence: &Evidence<'_>) -> Vec<(String, Places)> {
    let (inputs, outputs) = (evidence.court.formula.inputs(), evidence.court.formula.outputs());
    if evidence.court.wanted == Wanted::Products {
        return Vec::new();
    }
    let count = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
    let (n, m) = (count(inputs), count(outputs));
    let same: Places = (0..evidence.names.len()).collect();
    let has_jacobian = same.len() > m;
    let entry = |i: usize, j: usize| m + i * n + j;
    let mut exchanges = Vec::new();
    if has_jacobian {
        let (mut written, mut read) = (same.clone(), same.clone());
        for k in 0..m * n {
            written[m + k] = entry(k % m, k / m);
            read[m + k] = m + k / n + (k % n) * m;
        }
        let transposed = if m == n { "the Jacobian is transposed, or " } else { "" };
        exchanges.push((format!("{transposed}the Jacobian is written column by column, not row by row"), written));
        exchanges.push(("the Jacobian is read column by column from a list row by row".into(), read));
        exchanges.extend(blocks(inputs, outputs, &same, entry));
    }
    exchanges.extend(matrices(outputs, &same, n, has_jacobian));
    for (what, fields, is_row) in [("outputs", outputs, true), ("derivatives with respect to", inputs, false)] {
        if !is_row && !has_jacobian {
            continue;
        }
        for (name, a, b) in pairs(fields) {
            let mut swapped = same.clone();
            if is_row {
                swapped.swap(a, b);
            }
            let crossing = if !has_jacobian {
                0
            } else if is_row {
                n
            } else {
                m
            };
            for k in 0..crossing {
                let of = |line| if is_row { entry(line, k) } else { entry(k, line) };
                swapped.swap(of(a), of(b));
            }
            exchanges.push((format!("exchanged: the {what} {name}"), swapped));
        }
    }
    if has_jacobian {
        for (name, a, b) in pairs(outputs) {
            let mut swapped = same.clone();
            (0..n).for_each(|k| swapped.swap(entry(a, k), entry(b, k)));
            exchanges.push((format!("exchanged: the derivatives of {name}"), swapped));
        }
        exchanges.extend(columns(inputs, outputs, &same, entry));
    }
    exchanges
}

/// The derivatives with respect to two inputs exchanged: of all outputs, or of one.
fn columns(
    inputs: &[Field],
    outputs: &[Field],
    same: &Places,
    entry: impl Fn(usize, usize) -> usize,
) -> Vec<(String, Places)> {
    let starts = |fields: &[Field]| {
        let mut next = 0;
        let start = |field: &Field| {
            next += field.len();
            (*field, next - field.len())
        };
        fields.iter().map(start).collect::<Vec<_>>()
    };
    let (inputs, outputs) = (starts(inputs), starts(outputs));
    let m: usize = outputs.iter().map(|(field, _)| field.len()).sum();
    let rows = outputs.iter().map(|(field, start)| (format!(" of {}", field.name), *start..start + field.len()));
    let all = [(String::new(), 0..m)].into_iter().chain(rows.filter(|_| outputs.len() > 1));
    let mut exchanges = Vec::new();
    for (whose, rows) in all {
        for (k, (a, first)) in inputs.iter().enumerate() {
            for (b, second) in inputs[k + 1..].iter().filter(|(b, _)| a.len() == b.len()) {
                let mut swapped = same.clone();
                for i in rows.clone() {
                    (0..a.len()).for_each(|j| swapped.swap(entry(i, first + j), entry(i, second + j)));
                }
                exchanges.push((format!("exchanged: the derivatives{whose} by {} and {}", a.name, b.name), swapped));
            }
        }
    }
    exchanges
}

/// Square blocks of the Jacobian transposed: all at once, or a single one.
fn blocks(
    inputs: &[Field],
    outputs: &[Field],
    same: &Places,
    entry: impl Fn(usize, usize) -> usize,
) -> Vec<(String, Places)> {
    let (mut all, mut each) = (same.clone(), Vec::new());
    let mut row = 0;
    for output in outputs {
        let mut column = 0;
        for input in inputs {
            if output.len() == input.len() && output.len() > 1 {
                let mut one = same.clone();
                for i in 0..output.len() {
                    for j in 0..i {
                        let (a, b) = (entry(row + i, column + j), entry(row + j, column + i));
                        one.swap(a, b);
                        all.swap(a, b);
                    }
                }
                each.push((format!("transposed: the block ∂{}/∂{}", output.name, input.name), one));
            }
            column += input.len();
        }
        row += output.len();
    }
    each.push(("transposed: every square block of the Jacobian".into(), all));
    each
}

/// Outputs that are matrices, transposed.
fn matrices(outputs: &[Field], same: &Places, n: usize, has_jacobian: bool) -> Vec<(String, Places)> {
    let (m, mut first, mut exchanges) = (outputs.iter().map(Field::len).sum::<usize>(), 0, Vec::new());
    for output in outputs {
        if output.len() == 9 {
            let mut transposed = same.clone();
            transpose(&mut transposed, first, [m, if has_jacobian { n } else { 0 }]);
            exchanges.push((format!("transposed: the matrix {}", output.name), transposed));
        }
        first += output.len();
    }
    exchanges
}

/// Transposes an output that is a 3×3 matrix starting at this index, with the given number of derivatives; there are m outputs.
pub(super) fn transpose(places: &mut [usize], first: usize, [m, derivatives]: [usize; 2]) {
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        let (a, b) = (first + 3 * i + j, first + 3 * j + i);
        places.swap(a, b);
        for k in 0..derivatives {
            places.swap(m + a * derivatives + k, m + b * derivatives + k);
        }
    }
}

/// Pairs of components, with a name for each pair.
fn pairs(fields: &[Field]) -> Vec<(String, usize, usize)> {
    let component = |field: &Field| {
        let name = field.name;
        let of = |k: usize| if field.len() == 1 { name.to_owned() } else { format!("{name}[{k}]") };
        (0..field.len()).map(of).collect::<Vec<_>>()
    };
    let names: Vec<_> = fields.iter().flat_map(component).collect();
    let mut pairs = Vec::new();
    for b in 0..names.len() {
        pairs.extend((0..b).map(|a| (format!("{} and {}", names[a], names[b]), a, b)));
    }
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_is_transposed_where_it_stands() {
        // A number, a matrix, another number, and their derivatives with respect to two inputs.
        let (first, m, n) = (1, 11, 2);
        let same: Vec<usize> = (0..m + m * n).collect();
        let of =
            |k: usize| if (first..first + 9).contains(&k) { first + (k - first) % 3 * 3 + (k - first) / 3 } else { k };
        let expected = |place: usize| {
            if place < m { of(place) } else { m + of((place - m) / n) * n + (place - m) % n }
        };
        let mut places = same.clone();
        transpose(&mut places, first, [m, n]);
        assert_eq!(places, same.iter().copied().map(expected).collect::<Vec<_>>());
        transpose(&mut places, first, [m, n]);
        assert_eq!(places, same);
    }
}
