//! The points at which an export is compared, and the results of Rust there.

use super::recorded::{Recorded, Subject};
use jointproof::Error;
use jointproof::formula::proof::Case;
use jointproof::toolkit::measure::Options;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

/// A point, with the result of Rust.
pub(super) struct Point {
    pub(super) name: String,
    pub(super) inputs: Vec<f64>,
    pub(super) expected: Expected,
}

/// The result of Rust at a point.
pub(super) enum Expected {
    /// The outputs of the function with all results.
    Results(Vec<f64>),
    /// The inputs are rejected with this code.
    Refused(u32),
    /// The results are too large for doubles, which programs in other languages do not check.
    TooLarge,
}

/// The points of each: all cases, valid or not, one on each kink of a formula, and random ones.
pub(super) fn all(recorded: &[Recorded], samples: usize) -> Vec<Vec<Point>> {
    recorded.par_iter().map(|one| of(one, samples)).collect()
}

fn of(one: &Recorded, samples: usize) -> Vec<Point> {
    let point = |(name, inputs): (String, Vec<f64>)| {
        let expected = match results(one, &inputs) {
            Ok(results) => Expected::Results(results),
            Err(error) => code(one, &error).map_or(Expected::TooLarge, Expected::Refused),
        };
        Point { name, inputs, expected }
    };
    let named = |case: Case<Vec<f64>>| (case.id, case.inputs);
    let formula = match one.subject {
        Subject::Formula(formula) => formula,
        Subject::Element(element, rubs) => {
            return element.cases(rubs, samples).into_iter().map(named).map(point).collect();
        }
    };
    let options = Options { timing_points: samples, ..Options::quick() };
    let random = formula.timing_inputs(&options);
    let random = random.chunks(one.row()).enumerate().map(|(k, inputs)| (format!("random {k}"), inputs.to_vec()));
    let kinks = formula.kinks().into_iter().map(|kink| (format!("kink {}", kink.condition), kink.at));
    formula.golden_cases().into_iter().map(named).chain(kinks).chain(random).map(point).collect()
}

/// The results of Rust.
fn results(one: &Recorded, inputs: &[f64]) -> Result<Vec<f64>, Error> {
    match one.subject {
        Subject::Formula(formula) => {
            let (value, jacobian) = formula.value_and_closed_jacobian(inputs)?;
            Ok([value, jacobian].concat())
        }
        Subject::Element(element, rubs) => element.value(inputs, rubs),
    }
}

/// The return code of an error: the position of the input, or of a joint condition after all inputs.
fn code(one: &Recorded, error: &Error) -> Option<u32> {
    let inputs = one.inputs();
    let together = || one.graph.refusals.iter().position(|known| known.is_alike(error)).map(|k| inputs.len() + k + 1);
    let code = match error {
        Error::NonFinite { name, .. } | Error::OutOfRange { name, .. } => {
            let alone = inputs.iter().position(|field| field.name == name.field).map(|k| k + 1);
            // A negative radius is in the domain of a coordinate, so that the joint condition rejects it.
            together().or(alone)
        }
        _ => together(),
    };
    code.map(|code| u32::try_from(code).expect("there are few inputs"))
}

#[cfg(test)]
mod tests {
    use super::super::recorded::formulas;
    use super::{Expected, all, code};
    use jointproof::catalog::find;

    #[test]
    fn golden_cases_kinks_and_random_points_are_compared() {
        let formula = find("slot.friction").unwrap();
        let recorded = formulas(&[formula.spec().id]);
        let points = all(&recorded, 3).swap_remove(0);
        let names: Vec<_> = points.iter().map(|point| point.name.as_str()).collect();
        let cases: Vec<_> = formula.golden().cases.into_iter().map(|case| case.id).collect();
        let kinks: Vec<_> = formula.kinks().iter().map(|kink| format!("kink {}", kink.condition)).collect();
        assert!(!kinks.is_empty() && cases.len() > 1);
        let random = ["random 0", "random 1", "random 2"].map(String::from);
        assert_eq!(names, [&cases[..], &kinks, &random].concat());
        let mut refused = 0;
        for point in &points {
            match (&point.expected, formula.value_and_jacobian(&point.inputs)) {
                (Expected::Results(found), Ok((value, jacobian))) => {
                    let expected = [value, jacobian].concat();
                    assert!(
                        found.iter().map(|x| x.to_bits()).eq(expected.iter().map(|x| x.to_bits())),
                        "{}",
                        point.name
                    );
                }
                (Expected::Refused(found), Err(error)) => {
                    refused += 1;
                    assert_eq!(code(&recorded[0], &error), Some(*found), "{}", point.name);
                }
                (Expected::TooLarge, Err(error)) => assert_eq!(code(&recorded[0], &error), None, "{}", point.name),
                _ => panic!("{}", point.name),
            }
        }
        assert!(refused > 0);
    }

    #[test]
    fn an_input_that_is_refused_is_told_by_its_position() {
        let formula = find("slot.friction").unwrap();
        let recorded = formulas(&[formula.spec().id]);
        let valid = formula.timing_inputs(&jointproof::toolkit::measure::Options {
            timing_points: 1,
            ..jointproof::toolkit::measure::Options::quick()
        });
        let mut from = 0;
        for (k, field) in formula.inputs().iter().enumerate() {
            let mut inputs = valid.clone();
            inputs[from + field.len() - 1] = f64::NAN;
            let error = formula.value_and_jacobian(&inputs).unwrap_err();
            assert_eq!(code(&recorded[0], &error), Some(u32::try_from(k).unwrap() + 1), "{}", field.name);
            from += field.len();
        }
    }

    #[test]
    fn what_is_required_of_all_inputs_has_a_code_behind_theirs() {
        let formula = find("slide_line.contact_area_parabolic").unwrap();
        let recorded = formulas(&[formula.spec().id]);
        let (inputs, refusals) = (formula.inputs().len(), &recorded[0].graph.refusals);
        assert!(refusals.len() > 1, "{refusals:?}");
        let codes: Vec<_> = refusals.iter().filter_map(|error| code(&recorded[0], error)).collect();
        assert!(codes.iter().map(|&code| code as usize).eq(inputs + 1..=inputs + refusals.len()), "{codes:?}");
    }
}
