//! A worked example of a formula: a golden case that can be read at a glance.

use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::formula::proof::{Flag, RUNNING};
use jointproof::toolkit::verify::golden::{File, Record, components};

use super::content::Worked;

/// Significant digits shown.
const DIGITS: usize = 6;

/// Of the entries of a matrix.
const DIGITS_OF_ENTRIES: usize = 4;

/// The largest number of outputs shown.
const OUTPUTS: usize = 4;

/// The largest number of derivatives shown.
const DERIVATIVES: usize = 2;

/// Up to this number of inputs, each should be informative.
const FEW: usize = 5;

/// Up to this number of components, all inputs are shown; beyond, only those that are not 0.
const ALL: usize = 9;

/// Selects a valid case, with derivatives if they are in closed form: that of the running state of its chapter; else preferably
/// without an output of 0, worked by hand, and with few inputs of 0; among these the shortest.
pub(crate) fn of(formula: &dyn AnyFormula, golden: &File) -> Option<Worked> {
    let [inputs, outputs] = [formula.inputs(), formula.outputs()];
    let shown = |case: &Record| {
        let point = components(inputs, &case.inputs).ok()?;
        let has_all = case.out.is_some() && case.jac.is_some() == formula.spec().is_closed();
        let (value, jacobian) = has_all.then(|| formula.value_and_closed_jacobian(&point).ok())??;
        let worked = Worked {
            case: case.id.clone(),
            inputs: given(inputs, &point),
            outputs: first(numbers(outputs, &value)),
            derivatives: derivatives(inputs, outputs, &jacobian),
        };
        let zeros = if point.len() <= FEW { point.iter().filter(|x| **x == 0.0).count() } else { 0 };
        let is_zero = value.contains(&0.0) || !jacobian.is_empty() && worked.derivatives.is_empty();
        let length = [&worked.inputs, &worked.outputs, &worked.derivatives]
            .map(|parts| parts.concat().len())
            .iter()
            .sum::<usize>();
        Some(((case.id != RUNNING, is_zero, !case.flags.contains(&Flag::Hand), zeros, length), worked))
    };
    golden.cases.iter().filter_map(shown).min_by_key(|(rank, _)| *rank).map(|(_, worked)| worked)
}

/// The inputs; if there are many, those that are not 0, with a remark that the rest is.
fn given(fields: &[Field], point: &[f64]) -> Vec<String> {
    if point.len() <= ALL {
        return numbers(fields, point);
    }
    let mut at = 0;
    let mut shown = Vec::new();
    let mut rest = false;
    for field in fields {
        let part = &point[at..at + field.len()];
        at += field.len();
        if part.iter().all(|x| *x == 0.0) {
            rest = true;
        } else {
            shown.extend(numbers(std::slice::from_ref(field), part));
        }
    }
    shown.extend(rest.then(|| "the rest 0".into()));
    shown
}

/// The first ones, with a remark that there are more.
fn first(mut texts: Vec<String>) -> Vec<String> {
    if texts.len() > OUTPUTS {
        texts.truncate(OUTPUTS);
        texts.push("…".into());
    }
    texts
}

/// `$f_2 = 3$` for each field.
pub(crate) fn numbers(fields: &[Field], components: &[f64]) -> Vec<String> {
    let mut at = 0;
    let one = |field: &Field| {
        let part = &components[at..at + field.len()];
        at += field.len();
        let latex = field.quantity.latex;
        let (sign, numbers) = digits(part);
        match &*numbers {
            [one] => format!("${latex} {sign} {one}$"),
            // Plain text, in which lines may break.
            several => format!("${latex} {sign}$ {}", in_brackets(several)),
        }
    };
    fields.iter().map(one).collect()
}

/// The numbers in LaTeX, and whether they are exact: `=` and `3`, `\approx` and `0.333333`.
fn digits(numbers: &[f64]) -> (&'static str, Vec<String>) {
    let (texts, shown): (Vec<_>, Vec<_>) = numbers.iter().map(|&x| short(x)).unzip();
    (if shown == numbers { "=" } else { r"\approx" }, texts)
}

/// A number in LaTeX as plain text, with mathematics only if it has an exponent.
fn plain(latex: &str) -> String {
    if latex.contains('^') { format!("${latex}$") } else { latex.replace('-', "−") }
}

/// Numbers in brackets, rounded to few digits.
pub(crate) fn listed(numbers: &[f64]) -> String {
    in_brackets(&digits(numbers).1)
}

fn in_brackets(numbers: &[String]) -> String {
    format!("({})", numbers.iter().map(|text| plain(text)).collect::<Vec<_>>().join(", "))
}

/// A matrix in LaTeX, rounded to few digits.
pub(crate) fn matrix(rows: &[Vec<f64>]) -> String {
    let row = |row: &Vec<f64>| row.iter().map(|&x| to_digits(x, DIGITS_OF_ENTRIES).0).collect::<Vec<_>>().join(" & ");
    format!(r"\begin{{pmatrix}} {} \end{{pmatrix}}", rows.iter().map(row).collect::<Vec<_>>().join(r" \\ "))
}

/// A number in LaTeX with few digits, and the value of those digits.
fn short(x: f64) -> (String, f64) {
    to_digits(x, DIGITS)
}

fn to_digits(x: f64, digits: usize) -> (String, f64) {
    let text = format!("{x:.*e}", digits - 1);
    let rounded: f64 = text.parse().unwrap_or(x);
    let plain = format!("{}", rounded + 0.0);
    if plain.len() <= digits + 4 {
        return (plain, rounded);
    }
    let text = format!("{rounded:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mantissa = if mantissa == "1" { String::new() } else { format!(r"{mantissa}\cdot ") };
    (format!("{mantissa}10^{{{exponent}}}"), rounded)
}

/// The first non-zero derivatives, for scalars only.
fn derivatives(inputs: &[Field], outputs: &[Field], jacobian: &[f64]) -> Vec<String> {
    let [rows, columns] = [outputs, inputs].map(symbols);
    let entries = rows.iter().flat_map(|row| columns.iter().map(move |column| (row, column)));
    let shown = entries.zip(jacobian).filter(|(_, x)| **x != 0.0).take(DERIVATIVES).map(|((row, column), &x)| {
        let (sign, text) = digits(&[x]);
        format!(r"$\partial {row}/\partial {column} {sign} {}$", text.concat())
    });
    shown.collect()
}

/// The symbol of every component.
fn symbols(fields: &[Field]) -> Vec<String> {
    let of = |field: &Field| -> Vec<String> {
        let latex = field.quantity.latex;
        match field.len() {
            1 => vec![latex.into()],
            many => (1..=many).map(|k| format!("({latex})_{{{k}}}")).collect(),
        }
    };
    fields.iter().flat_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::find;

    #[test]
    fn a_worked_number_is_short_and_says_where_it_is_rounded() {
        let formula = find("slot.contact_force").unwrap();
        let worked = of(formula, &formula.golden()).unwrap();
        assert_eq!(worked.case, "running");
        assert_eq!(worked.inputs, ["$f_2 = 3$", "$f_3 = 4$"]);
        assert_eq!(worked.outputs, ["$F_C = 5$"]);
        assert_eq!(worked.derivatives, [r"$\partial F_C/\partial f_2 = 0.6$", r"$\partial F_C/\partial f_3 = 0.8$"]);
        assert_eq!(digits(&[1.0 / 3.0]), (r"\approx", vec!["0.333333".into()]));
        assert_eq!(digits(&[1e-9, -0.0]), ("=", vec!["10^{-9}".into(), "0".into()]));
        assert_eq!([plain("-0.5"), plain("10^{-9}")], ["−0.5", "$10^{-9}$"]);
    }

    #[test]
    fn an_automatic_jacobian_has_no_worked_derivatives() {
        let formula = find("universal.nodal_moments").unwrap();
        let worked = of(formula, &formula.golden()).unwrap();
        assert!(!worked.outputs.is_empty() && worked.derivatives.is_empty());
    }

    #[test]
    fn numbers_of_ten_letters_are_written_out_and_longer_ones_with_a_power() {
        for (x, text) in [
            (0.001_234_567, "0.00123457"),
            (0.000_123_456_7, r"1.23457\cdot 10^{-4}"),
            (1_234_567_890.0, "1234570000"),
            (-1_234_567_890.0, r"-1.23457\cdot 10^{9}"),
            (1e10, "10^{10}"),
            (-0.0, "0"),
        ] {
            assert_eq!(short(x).0, text);
        }
    }

    #[test]
    fn of_many_inputs_those_are_shown_that_are_not_0() {
        let fields = find("join.rows").unwrap().inputs();
        let count = fields.iter().map(Field::len).sum::<usize>();
        assert!(count > ALL, "{count} components");
        let mut point = vec![0.0; count];
        assert_eq!(given(fields, &point), ["the rest 0"]);
        let after = fields[0].len();
        point[after] = 2.0;
        let shown = given(fields, &point);
        let second = format!("${} =$ (2, 0, 0)", fields[1].quantity.latex);
        assert_eq!(shown, [second, "the rest 0".to_owned()]);
        let ones = given(fields, &vec![1.0; count]);
        assert_eq!(ones.len(), fields.len(), "{ones:?}");
    }

    #[test]
    fn few_outputs_are_shown_and_that_there_are_more() {
        let texts = |count: usize| (0..count).map(|k| k.to_string()).collect::<Vec<_>>();
        assert_eq!(first(texts(4)), ["0", "1", "2", "3"]);
        assert_eq!(first(texts(5)), ["0", "1", "2", "3", "…"]);
    }
}
