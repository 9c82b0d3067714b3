//! Known mistakes of a tangent: each says what the matrix would be for the derivative as it is; the first that is right for
//! every entry at every state is the cause.

use super::compared::{Compared, Table};
use super::spec::Turning;

/// How precisely a mistake must give the matrix, in parts of the largest of a row.
const PRECISION: f64 = 1e-7;

/// The cause of a wrong matrix, in words; `None` for one that is not known. `dim` is the number of coordinates of a node.
pub(super) fn cause(all: &[Compared], names: [&str; 3], by: Turning, dim: usize) -> Option<String> {
    let matrix = names[2].trim_start_matches('-');
    whole(all, names)
        .or_else(|| rotations(all, matrix, by))
        .or_else(|| of_state(all, names, dim))
        .or_else(|| parts(all, names))
}

/// Whether these matrices are those of the routine at every state.
fn explains(all: &[Compared], expected: impl Fn(&Compared, usize, usize) -> f64) -> bool {
    let mut tells = false;
    let well = all.iter().all(|one| {
        let found = one.found();
        (0..found.entries.len()).all(|k| {
            let (row, column) = (k / found.columns, k % found.columns);
            let (is, expected) = (found.at(row, column), expected(one, row, column));
            let (exact, unit) = (one.exact.at(row, column), one.units.at(row, column));
            let allowed = 30.0 * one.errors.at(row, column) + PRECISION * unit;
            tells |= (is - exact).abs() > 10.0 * allowed;
            !allowed.is_finite() || (is - expected).abs() <= allowed
        })
    });
    well && tells
}

fn is_square(all: &[Compared]) -> bool {
    all.iter().all(|one| one.found().rows() == one.found().columns)
}

/// An entry of a matrix, by that of the right one.
type Form = fn(&Table, usize, usize) -> f64;

/// Mistakes of the whole matrix.
fn whole(all: &[Compared], [value, input, name]: [&str; 3]) -> Option<String> {
    let matrix = name.trim_start_matches('-');
    if explains(all, |one, r, c| -one.exact.at(r, c)) {
        let sign = if name.starts_with('-') { "plus" } else { "minus" };
        return Some(format!("wrong sign: {matrix} is {sign} the derivative of {value} with respect to {input}"));
    }
    if explains(all, |_, _, _| 0.0) {
        return Some(format!("{matrix} is 0 throughout"));
    }
    if let Some(factor) = factor(all, |_, _| true).filter(|&f| explains(all, |one, r, c| f * one.exact.at(r, c))) {
        return Some(format!("{matrix} is {}", times(factor)));
    }
    if !is_square(all) {
        return None;
    }
    let forms: [(&str, Form); 9] = [
        ("is transposed: its rows are columns", |d, r, c| d.at(c, r)),
        ("is transposed, and its sign reversed", |d, r, c| -d.at(c, r)),
        ("is symmetrised: half of the sum of the derivative and its transpose", |d, r, c| {
            f64::midpoint(d.at(r, c), d.at(c, r))
        }),
        ("has its upper triangle in the lower one, too: the derivative is not symmetric", |d, r, c| {
            d.at(r.min(c), r.max(c))
        }),
        ("has its lower triangle in the upper one, too: the derivative is not symmetric", |d, r, c| {
            d.at(r.max(c), r.min(c))
        }),
        ("has only its upper triangle", |d, r, c| if r <= c { d.at(r, c) } else { 0.0 }),
        ("has only its lower triangle", |d, r, c| if r >= c { d.at(r, c) } else { 0.0 }),
        ("has only its diagonal", |d, r, c| if r == c { d.at(r, c) } else { 0.0 }),
        ("has its diagonal twice", |d, r, c| if r == c { 2.0 * d.at(r, c) } else { d.at(r, c) }),
    ];
    let found = forms.into_iter().find(|(_, form)| explains(all, |one, r, c| form(&one.exact, r, c)));
    found.map(|(words, _)| format!("{matrix} {words}"))
}

fn times(factor: f64) -> String {
    let degrees = std::f64::consts::PI / 180.0;
    let is = |known: f64| (factor / known - 1.0).abs() < 1e-6;
    let known = [(2.0, "twice"), (0.5, "half"), (-2.0, "minus twice"), (-0.5, "minus half"), (-1.0, "minus")];
    if let Some((_, word)) = known.into_iter().find(|&(known, _)| is(known)) {
        return format!("{word} what it should be");
    }
    let power = factor.abs().log10();
    let why = if is(degrees) || is(1.0 / degrees) {
        " (units: degrees for radians)"
    } else if (power - power.round()).abs() < 1e-6 {
        " (units)"
    } else {
        ""
    };
    format!("{} times what it should be{why}", rounded(factor))
}

fn rounded(x: f64) -> String {
    let text = format!("{x:.9}");
    if x.abs() < 1e-3 || x.abs() >= 1e6 {
        format!("{x:.6e}")
    } else {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    }
}

/// The one factor between matrix and derivative, of the entries asked for.
fn factor(all: &[Compared], of: impl Fn(usize, usize) -> bool) -> Option<f64> {
    let mut found = None;
    let mut most = 0.0;
    for one in all {
        let matrix = one.found();
        for row in 0..matrix.rows() {
            for column in 0..matrix.columns {
                let part = one.exact.at(row, column).abs() / one.units.at(row, column);
                if of(row, column) && one.is_decided(row, column) && part > most {
                    most = part;
                    found = Some(matrix.at(row, column) / one.exact.at(row, column));
                }
            }
        }
    }
    found.filter(|factor: &f64| factor.is_finite() && *factor != 0.0)
}

/// Rotations varied in the other way.
fn rotations(all: &[Compared], matrix: &str, by: Turning) -> Option<String> {
    let is_otherwise = explains(all, |one, r, c| one.otherwise.as_ref().unwrap_or(&one.exact).at(r, c));
    is_otherwise.then(|| match by {
        Turning::Spin => format!(
            "rotation vector for spin: {matrix} is the derivative with respect to the components of rotation vectors, and a program that \
             compounds rotations, as Abaqus does, needs that with respect to spins"
        ),
        Turning::Vector => {
            format!("spin for rotation vector: {matrix} is the derivative with respect to spins, and not to the components of rotation vectors")
        }
    })
}

/// Matrices of another state.
fn of_state(all: &[Compared], [value, input, name]: [&str; 3], dim: usize) -> Option<String> {
    let matrix = name.trim_start_matches('-');
    if all.iter().any(|one| {
        let [first, last] = &one.at.found;
        first.entries.iter().zip(&last.entries).any(|(a, b)| (a - b).abs() > PRECISION * (a.abs() + b.abs()))
    }) {
        return Some(format!("{matrix} depends on the call before: asked twice at a state, it differs"));
    }
    let rest = all.iter().find(|one| one.at.x.iter().all(|&x| x == 0.0));
    if let Some(rest) = rest {
        if explains(all, |_, r, c| rest.exact.at(r, c)) {
            return Some(format!("{matrix} is that of {input} = 0 at every state: the initial stiffness"));
        }
        let secant = all.iter().all(|one| {
            (0..one.found().rows()).all(|row| {
                let terms = || (0..one.at.x.len()).map(|k| one.found().at(row, k) * one.at.x[k]);
                let size = terms().fold(1e-300, |sum, term| sum + term.abs());
                (terms().sum::<f64>() - (one.at.value[row] - rest.at.value[row])).abs() <= PRECISION * size
            })
        });
        if secant {
            return Some(format!(
                "{matrix} is a secant stiffness: times {input} it gives {value}, but it is not its derivative"
            ));
        }
        let others = all.iter().filter(|one| !std::ptr::eq(*one, rest));
        let is_elsewhere = others.clone().all(|one| !one.wrong().is_empty());
        let carries = |one: &Compared| one.at.value.iter().any(|force| force.abs() > 0.0);
        if rest.wrong().is_empty() && is_elsewhere && others.clone().all(carries) && is_square(all) && is_symmetric(all)
        {
            let part = if is_geometric(all, dim) {
                "the geometric stiffness"
            } else {
                "a term that comes with stresses or strains"
            };
            return Some(format!("{matrix} is right at {input} = 0, and what it lacks elsewhere is symmetric: {part}"));
        }
    }
    None
}

/// Whether what a matrix lacks is symmetric.
fn is_symmetric(all: &[Compared]) -> bool {
    all.iter().all(|one| {
        let lacks = one.found().like(|r, c| one.found().at(r, c) - one.exact.at(r, c));
        let allowed = |r: usize, c: usize| 30.0 * one.errors.at(r, c) + PRECISION * one.units.at(r, c);
        (0..lacks.rows())
            .all(|r| (0..r).all(|c| (lacks.at(r, c) - lacks.at(c, r)).abs() <= allowed(r, c) + allowed(c, r)))
    })
}

/// Whether what a matrix lacks is, for each two nodes, a multiple of the unit matrix, as stresses times gradients are.
fn is_geometric(all: &[Compared], dim: usize) -> bool {
    all.iter().all(|one| {
        let found = one.found();
        let lacks = |r: usize, c: usize| found.at(r, c) - one.exact.at(r, c);
        (0..found.entries.len()).all(|k| {
            let (r, c) = (k / found.columns, k % found.columns);
            let [i, j] = [r % dim, c % dim];
            let expected = if i == j { lacks(r - i, c - j) } else { 0.0 };
            let allowed = |r: usize, c: usize| 30.0 * one.errors.at(r, c) + PRECISION * one.units.at(r, c);
            (lacks(r, c) - expected).abs() <= allowed(r, c) + allowed(r - i, c - j)
        })
    })
}

/// Mistakes of single entries, rows, columns and blocks.
fn parts(all: &[Compared], [value, input, name]: [&str; 3]) -> Option<String> {
    let matrix = name.trim_start_matches('-');
    let wrong = wrong(all);
    let is_wrong = |r: usize, c: usize| wrong.binary_search(&(r, c)).is_ok();
    let place = place(all);
    let by =
        |f: f64| explains(all, |one, r, c| if is_wrong(r, c) { f * one.exact.at(r, c) } else { one.exact.at(r, c) });
    if by(0.0) {
        return Some(format!("missing: {matrix}{place} is 0, and {value} depends on {input} there"));
    }
    if by(-1.0) {
        return Some(format!("wrong sign: {matrix}{place}"));
    }
    if let Some(factor) = factor(all, is_wrong).filter(|&factor| by(factor)) {
        return Some(format!("{matrix}{place} is {}", times(factor)));
    }
    if is_square(all) {
        let transposed = |one: &Compared, r: usize, c: usize| {
            if is_wrong(r, c) { one.exact.at(c, r) } else { one.exact.at(r, c) }
        };
        if explains(all, transposed) {
            return Some(format!("{matrix}{place} is transposed"));
        }
    }
    exchanged(all, matrix).or_else(|| inexact(all, matrix))
}

/// The entries that are wrong at a state or more, in order.
fn wrong(all: &[Compared]) -> Vec<(usize, usize)> {
    let mut wrong: Vec<_> = all.iter().flat_map(Compared::wrong).collect();
    wrong.sort_unstable();
    wrong.dedup();
    wrong
}

/// Where the wrong entries are: `(1:3,7)`.
pub(super) fn place(all: &[Compared]) -> String {
    all.first().map_or(String::new(), |one| block(&wrong(all), one.found().rows(), one.found().columns))
}

/// Two rows or two columns that are exchanged.
fn exchanged(all: &[Compared], matrix: &str) -> Option<String> {
    let first = all.first()?.found();
    let pairs = |count: usize| (0..count).flat_map(|a| (0..a).map(move |b| (b, a)));
    let swapped = |k: usize, (a, b): (usize, usize)| {
        if k == a {
            b
        } else if k == b {
            a
        } else {
            k
        }
    };
    let rows = pairs(first.rows()).find(|&pair| explains(all, |one, r, c| one.exact.at(swapped(r, pair), c)));
    if let Some((a, b)) = rows {
        return Some(format!("rows {} and {} of {matrix} are exchanged", a + 1, b + 1));
    }
    let columns = pairs(first.columns).find(|&pair| explains(all, |one, r, c| one.exact.at(r, swapped(c, pair))));
    if let Some((a, b)) = columns {
        return Some(format!("columns {} and {} of {matrix} are exchanged", a + 1, b + 1));
    }
    let both = pairs(first.rows().min(first.columns))
        .find(|&pair| explains(all, |one, r, c| one.exact.at(swapped(r, pair), swapped(c, pair))));
    both.map(|(a, b)| format!("rows and columns {} and {} of {matrix} are exchanged", a + 1, b + 1))
}

/// Digits that are lost throughout.
fn inexact(all: &[Compared], matrix: &str) -> Option<String> {
    let off = all.iter().flat_map(|one| one.wrong().into_iter().map(move |(r, c)| one.digits(r, c)));
    let least = off.fold(f64::INFINITY, f64::min);
    if least.is_finite() && least >= 5.5 {
        return Some(format!(
            "{matrix} has {least:.1} digits only: a constant or a variable of single precision, or a difference quotient"
        ));
    }
    None
}

/// Rows and columns as short ranges: `(1:3,7)`; entries one by one where they are no block.
fn block(wrong: &[(usize, usize)], rows: usize, columns: usize) -> String {
    let distinct = |mut numbers: Vec<usize>| {
        numbers.sort_unstable();
        numbers.dedup();
        numbers
    };
    let (in_rows, in_columns) =
        (distinct(wrong.iter().map(|at| at.0).collect()), distinct(wrong.iter().map(|at| at.1).collect()));
    if wrong.len() <= 3 {
        let entries: Vec<_> = wrong.iter().map(|(r, c)| format!("({},{})", r + 1, c + 1)).collect();
        return entries.join(", ");
    }
    format!("({},{})", ranges(&in_rows, rows), ranges(&in_columns, columns))
}

/// Numbers from 0 on as ranges from 1 on; `:` for all.
fn ranges(numbers: &[usize], all: usize) -> String {
    if numbers.len() == all {
        return ":".into();
    }
    let mut texts: Vec<String> = Vec::new();
    let mut k = 0;
    while k < numbers.len() {
        let from = k;
        while k + 1 < numbers.len() && numbers[k + 1] == numbers[k] + 1 {
            k += 1;
        }
        texts.push(match k - from {
            0 => (numbers[k] + 1).to_string(),
            _ => format!("{}:{}", numbers[from] + 1, numbers[k] + 1),
        });
        k += 1;
    }
    if texts.len() == 1 { texts.concat() } else { format!("[{}]", texts.join(",")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_short() {
        assert_eq!(ranges(&[0, 1, 2], 3), ":");
        assert_eq!(ranges(&[0, 1, 3], 5), "[1:2,4]");
        assert_eq!(ranges(&[4], 5), "5");
        assert_eq!(block(&[(0, 1), (2, 2)], 3, 3), "(1,2), (3,3)");
        assert_eq!(block(&[(0, 3), (0, 4), (1, 3), (1, 4)], 6, 6), "(1:2,4:5)");
    }

    #[test]
    fn factors_have_names() {
        assert_eq!(times(2.0), "twice what it should be");
        assert_eq!(times(1000.0), "1000 times what it should be (units)");
        assert!(times(std::f64::consts::PI / 180.0).ends_with("(units: degrees for radians)"));
        assert_eq!(times(1.25), "1.25 times what it should be");
    }
}
