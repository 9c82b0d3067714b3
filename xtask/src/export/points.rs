//! The points at which an export is compared, and what Rust finds there.

use super::recorded::Recorded;
use jointproof::Error;
use jointproof::formula::Field;
use jointproof::measure::Options;
use jointproof::verify::golden::components;

/// A point of a formula, and what Rust says of it.
pub(super) struct Point {
    pub(super) name: String,
    pub(super) inputs: Vec<f64>,
    pub(super) expected: Expected,
}

/// What Rust says of a point.
pub(super) enum Expected {
    /// Value and Jacobian.
    Results(Vec<f64>),
    /// Inputs are refused by this code.
    Refused(u32),
    /// Results that are too large for doubles, which a program in another language does not look for.
    TooLarge,
}

/// The points of every formula: all golden cases, valid or not, one on each kink, and random ones.
pub(super) fn all(recorded: &[Recorded], samples: usize) -> Vec<Vec<Point>> {
    recorded.iter().map(|one| of(one, samples)).collect()
}

fn of(one: &Recorded, samples: usize) -> Vec<Point> {
    let formula = one.formula;
    let point = |name, inputs: Vec<f64>| {
        let expected = match formula.value_and_jacobian(&inputs) {
            Ok((value, jacobian)) => Expected::Results([value, jacobian].concat()),
            Err(error) => code(one, &error).map_or(Expected::TooLarge, Expected::Refused),
        };
        Point { name, inputs, expected }
    };
    let cases = formula.golden().cases;
    let cases = cases.into_iter().filter_map(|case| {
        let inputs = components(formula.inputs(), &case.inputs).ok()?;
        Some(point(case.id, inputs))
    });
    let options = Options { timing_points: samples, ..Options::quick() };
    let random = formula.timing_inputs(&options);
    let count = formula.inputs().iter().map(Field::len).sum();
    let random = random.chunks(count).enumerate().map(|(k, inputs)| point(format!("random {k}"), inputs.to_vec()));
    let kinks = formula.kinks().into_iter().map(|kink| point(format!("kink {}", kink.condition), kink.at));
    cases.chain(kinks).chain(random).collect()
}

/// The code by which an error is told: the position of the input, or of what is required behind all inputs.
fn code(one: &Recorded, error: &Error) -> Option<u32> {
    let inputs = one.formula.inputs();
    let together = || one.graph.refusals.iter().position(|known| known.is_alike(error)).map(|k| inputs.len() + k + 1);
    let code = match error {
        Error::NonFinite { name, .. } | Error::OutOfRange { name, .. } => {
            let alone = inputs.iter().position(|field| field.name == name.field).map(|k| k + 1);
            // A radius that is negative is in the domain of a coordinate.
            together().or(alone)
        }
        _ => together(),
    };
    code.map(|code| u32::try_from(code).expect("a formula has few inputs"))
}

#[cfg(test)]
mod tests {
    use super::super::recorded::record;
    use super::code;
    use jointproof::catalog::find;

    #[test]
    fn what_is_required_of_all_inputs_has_a_code_behind_theirs() {
        let formula = find("slide_line.contact_area_parabolic").unwrap();
        let (recorded, _) = record(&[formula], None);
        let (inputs, refusals) = (formula.inputs().len(), &recorded[0].graph.refusals);
        assert!(refusals.len() > 1, "{refusals:?}");
        let codes: Vec<_> = refusals.iter().filter_map(|error| code(&recorded[0], error)).collect();
        assert!(codes.iter().map(|&code| code as usize).eq(inputs + 1..=inputs + refusals.len()), "{codes:?}");
    }
}
