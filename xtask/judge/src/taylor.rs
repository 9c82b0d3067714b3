//! The slope of the Taylor remainder: whether products are derivatives of the program's own values, whether or not
//! those are right.
//!
//! If they are, |f(x + h v) − f(x) − h J v| decreases as h², otherwise as h.

use super::answer::Answer;
use super::map::names;
use super::question::{Along, Kind, Own, Question, Wanted, ladder, of_points, sizes, zeros};
use super::verdict::Court;
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::verify::{Options, Sampler};
use std::collections::{BTreeMap, BTreeSet};

/// The number of points, with one direction each.
const BASES: usize = 6;
/// The lengths of steps, each half of the previous one, in units of v, since the inputs have different units.
const STEPS: [f64; 3] = [1.0 / 256.0, 1.0 / 512.0, 1.0 / 1024.0];
/// A remainder that decreases faster than this power of h is of second order.
const SECOND_ORDER: f64 = 1.5;
/// The rounding error of the remainder, relative to the terms of the difference.
const NOISE: f64 = 64.0 * f64::EPSILON;

/// Values along a direction: at the starting point, with J v there, and after each step.
struct Values<'a> {
    start: &'a [f64],
    product: &'a [f64],
    behind: [&'a [f64]; STEPS.len()],
}

impl Values<'_> {
    /// The power of h with which the remainder of an output decreases; `None` if it is rounding error.
    fn slope(&self, output: usize, noise: f64) -> Option<f64> {
        let remainder =
            |k: usize| (self.behind[k][output] - self.start[output] - STEPS[k] * self.product[output]).abs();
        let [longest, shortest] = [0, STEPS.len() - 1];
        let [first, last] = [longest, shortest].map(remainder);
        (first > noise).then(|| (first / last.max(noise)).log2() / (STEPS[longest] / STEPS[shortest]).log2())
    }
}

/// All questions: two valid points first, so that a program can show its format. If products are requested, points
/// along directions follow.
pub fn questions(formula: &dyn AnyFormula, wanted: Wanted, options: &Options) -> Vec<Question> {
    let points = formula.judge().points(options);
    let last = points.last().map(|(_, inputs)| inputs.clone()).unwrap_or_default();
    let mut questions = of_points(formula, wanted, points, options.seed);
    let (rungs, points) = ladder(formula, &last)
        .into_iter()
        .map(|(rung, inputs)| {
            let name = format!("{} of size 1e{}", rung.fields.join(", "), rung.exponent);
            (rung, (name, inputs))
        })
        .unzip::<_, _, Vec<_>, Vec<_>>();
    let mut on_ladder = of_points(formula, wanted, points, options.seed);
    on_ladder.iter_mut().zip(rungs).for_each(|(question, rung)| question.kind = Kind::Rung(rung));
    on_ladder.extend(of_points(formula, wanted, zeros(formula, &last), options.seed));
    // The ladder shows limits; what no double holds, or is not allowed, is asked elsewhere.
    questions.extend(on_ladder.into_iter().filter(|question| matches!(question.own, Own::Results(_))));
    questions.sort_by_key(Question::must_be_refused);
    if wanted == Wanted::Products {
        questions.extend(along_directions(formula, &questions, options.seed));
    }
    questions
}

/// The questions along directions from the first random points that are valid and not near a kink.
fn along_directions(formula: &dyn AnyFormula, asked: &[Question], seed: u64) -> Vec<Question> {
    let mut sampler = Sampler::named("Taylor remainder", seed);
    let random = asked.iter().filter(|question| question.name.starts_with("random "));
    let from = |question: &Question| direction(formula, question, &mut sampler);
    let all = random.filter_map(from).take(BASES).enumerate();
    let numbered = |(base, questions): (usize, Vec<Question>)| {
        questions.into_iter().map(move |question| {
            let along = question.along.map(|along| Along { base, ..along });
            Question { along, ..question }
        })
    };
    all.flat_map(numbered).collect()
}

/// The questions along a direction: at its starting point and after each step.
fn direction(formula: &dyn AnyFormula, question: &Question, sampler: &mut Sampler) -> Option<Vec<Question>> {
    let x = &question.inputs;
    let (value, jacobian) = formula.value_and_jacobian(x).ok()?;
    let v = tangent(formula, x, sampler);
    let stepped = |step: f64| x.iter().zip(&v).map(|(x, v)| x + step * v).collect::<Vec<_>>();
    let [n, m] = sizes(formula);
    let row = |i: usize| jacobian[i * n..][..n].iter();
    let product: Vec<f64> = (0..m).map(|i| row(i).zip(&v).map(|(slope, v)| slope * v).sum()).collect();
    let size = |i: usize| value[i].abs() + row(i).zip(x).map(|(slope, x)| (slope * x).abs()).sum::<f64>();
    let noise: Vec<f64> = (0..m).map(|i| NOISE * size(i)).collect();
    let [Some(a), Some(b), Some(c)] =
        STEPS.map(|step| formula.value_and_jacobian(&stepped(step)).map(|(value, _)| value).ok())
    else {
        return None;
    };
    let behind = [a, b, c];
    let own = Values { start: &value, product: &product, behind: behind.each_ref().map(Vec::as_slice) };
    if (0..m).any(|i| own.slope(i, noise[i]).is_some_and(|slope| slope < SECOND_ORDER)) {
        return None;
    }
    let [_, w] = question.directions.as_ref()?;
    let at = |step: f64, value: Vec<f64>| Question {
        name: if step == 0.0 { question.name.clone() } else { format!("{}, {step} along v", question.name) },
        inputs: stepped(step),
        directions: Some([v.clone(), w.clone()]),
        own: Own::Results(value),
        kind: Kind::Ordinary,
        along: Some(Along { base: 0, noise: noise.clone() }),
    };
    let steps = [0.0].into_iter().chain(STEPS);
    Some(steps.zip([value.clone()].into_iter().chain(behind.iter().cloned())).map(|(h, y)| at(h, y)).collect())
}

/// A direction in which inputs can move, each in proportion to its size; those that would leave their domain stay fixed.
fn tangent(formula: &dyn AnyFormula, x: &[f64], sampler: &mut Sampler) -> Vec<f64> {
    let mut v = vec![0.0; x.len()];
    let mut first = 0;
    for field in formula.inputs() {
        let components = first..first + field.len();
        first = components.end;
        let size = x[components.clone()].iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let mut moved = x.to_vec();
        for k in components.clone() {
            let drawn = sampler.real();
            v[k] = size * drawn / (1.0 + drawn.abs());
            moved[k] += STEPS[0] * v[k];
        }
        if formula.value_and_jacobian(&moved).is_err() {
            v[components].fill(0.0);
        }
    }
    v
}

/// The conclusion from the remainders of a program's own values, in words; `None` if there are none.
pub(super) fn message(court: &Court<'_>, answers: &[Answer]) -> Option<String> {
    let m = sizes(court.formula)[1];
    let mut directions = BTreeMap::<usize, Vec<(&Along, &Answer)>>::new();
    for (question, answer) in court.questions.iter().zip(answers) {
        if let Some(along) = &question.along {
            directions.entry(along.base).or_default().push((along, answer));
        }
    }
    let names = names(court.formula.inputs(), court.formula.outputs(), Wanted::Value);
    let (mut least, mut seen, mut wrong) = (f64::INFINITY, 0, BTreeSet::new());
    for answered in directions.values() {
        let numbers: Option<Vec<_>> = answered.iter().map(|(_, answer)| given(answer, 2 * m)).collect();
        let Some([start, behind @ ..]) = numbers.as_deref() else { continue };
        let Ok(behind) = <&[Vec<f64>; STEPS.len()]>::try_from(behind) else { continue };
        let (values, product) = start.split_at(m);
        let values = Values { start: values, product, behind: behind.each_ref().map(Vec::as_slice) };
        seen += 1;
        for output in 0..m {
            if let Some(slope) = values.slope(output, answered[0].0.noise[output]) {
                least = least.min(slope);
                if slope < SECOND_ORDER {
                    wrong.insert(output);
                }
            }
        }
    }
    let along = format!("along {seen} directions");
    match (seen, wrong.is_empty()) {
        (0, _) => None,
        (_, true) if least.is_infinite() => Some(format!("J v are the differences of its own values {along}")),
        (_, true) => {
            Some(format!("J v are the derivatives of its own values {along}: the remainder falls as h^{least:.1}"))
        }
        (_, false) => {
            let wrong: Vec<_> = wrong.iter().map(|&output| names[output].as_str()).collect();
            let outputs = wrong.join(", ");
            Some(format!(
                "J v are not the derivatives of its own values of {outputs} {along}: the remainder falls as h^{least:.1}"
            ))
        }
    }
}

/// The first numbers of an answer, if all are given.
fn given(answer: &Answer, count: usize) -> Option<Vec<f64>> {
    match answer {
        Answer::Numbers(numbers) => numbers[..count].iter().copied().collect(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::find;
    use jointproof::toolkit::measure::Options;
    use jointproof::toolkit::verify;

    #[test]
    fn what_is_valid_is_asked_first() {
        let options = verify::Options { samples: 10, ..verify::Options::default() };
        let formula = find("slot.friction").unwrap();
        let asked = questions(formula, Wanted::Value, &options);
        let named = asked.iter().filter(|question| !matches!(question.kind, Kind::Rung(_))).count();
        assert!(named >= formula.judge().points(&options).len() && asked.len() > named);
        assert!(!asked[0].must_be_refused() && asked[asked.len() - 1].must_be_refused());
        assert!(asked.is_sorted_by_key(Question::must_be_refused));
    }

    #[test]
    fn a_remainder_falls_by_a_power_of_the_step() {
        // The first output has no remainder.
        let slope = |remainder: fn(f64) -> f64, noise: f64| {
            let behind = STEPS.map(|h| [9.0, 7.0 + 3.0 * h + remainder(h)]);
            let behind = behind.each_ref().map(<[f64; 2]>::as_slice);
            let values = Values { start: &[9.0, 7.0], product: &[0.0, 3.0], behind };
            assert_eq!(values.slope(0, noise), None);
            values.slope(1, noise)
        };
        let (first, last) = (STEPS[0] * STEPS[0], STEPS[2] * STEPS[2]);
        assert_eq!(slope(|h| h * h, 0.0), Some(2.0));
        assert_eq!(slope(|h| -h, 0.0), Some(1.0));
        // Rounding errors are ignored, and nothing decreases below them.
        assert_eq!(slope(|h| h * h, first), None);
        assert_eq!(slope(|h| h * h, 4.0 * last), Some(1.0));
    }

    #[test]
    fn there_are_directions_where_formulas_are_smooth() {
        for id in ["coulomb.yield", "slot.constraint", "cardan.angles"] {
            let formula = find(id).unwrap();
            let asked = super::questions(formula, Wanted::Products, &verify::Options::default());
            let all = along_directions(formula, &asked, 1);
            assert_eq!(all.len(), BASES * (1 + STEPS.len()), "{id}");
        }
    }

    /// The questions along a direction from a point of a formula.
    fn from(id: &str, x: &[f64], seed: u64) -> Option<Vec<Question>> {
        let formula = find(id).unwrap();
        let points = vec![("random 7".to_owned(), x.to_vec())];
        let asked = super::super::question::of_points(formula, Wanted::Products, points, 1);
        direction(formula, &asked[0], &mut Sampler::named("test", seed))
    }

    #[test]
    fn a_direction_has_its_beginning_and_its_steps() {
        let x = [3.0, 0.25, 5.0];
        let all = from("coulomb.yield", &x, 1).unwrap();
        let names: Vec<_> = all.iter().map(|question| question.name.as_str()).collect();
        let steps = ["0.00390625", "0.001953125", "0.0009765625"].map(|step| format!("random 7, {step} along v"));
        assert_eq!(names, [&["random 7"][..], &steps.each_ref().map(String::as_str)].concat());
        assert_eq!(all[0].inputs, x);
        let [longest, shortest] = [1, 3].map(|k: usize| [0, 1, 2].map(|j| all[k].inputs[j] - x[j]));
        for (longest, shortest) in longest.iter().zip(&shortest) {
            assert!(*shortest != 0.0 && (longest - 4.0 * shortest).abs() <= 1e-12 * longest.abs());
        }
    }

    #[test]
    fn what_rounding_leaves_is_told_by_all_terms() {
        // Φ = p − μ F_N; the contributions of the factors add the product once more each.
        let (p, mu, normal) = (1.0, 0.25, 8.0);
        let size = 1.0 + 1.0 + 2.0 + 2.0;
        for question in from("coulomb.yield", &[p, mu, normal], 1).unwrap() {
            assert_eq!(question.along.unwrap().noise, [NOISE * size]);
        }
    }

    #[test]
    fn there_is_no_direction_over_a_kink() {
        let are_over = |id: &str, x: &[f64]| (0..20).filter(|&seed| from(id, x, seed).is_none()).count();
        assert_eq!(are_over("coulomb.return_map", &[1.0, 0.5, 4.0]), 0);
        assert!(are_over("coulomb.return_map", &[2.0 - 1e-6, 0.5, 4.0]) > 5);
        // Of three outputs the second is undefined at F_N = 0.
        assert!(are_over("slot.friction", &[-2.0, 3.0, 4.0, -5.0 + 1e-6, 0.25]) > 5);
    }

    #[test]
    fn a_direction_is_squeezed_between_the_sizes_of_the_inputs() {
        let formula = find("slider.line").unwrap();
        let x = [1e-3, -0.5, 0.25, -8.0, 4.0, 2.0];
        for seed in 0..5 {
            let v = tangent(formula, &x, &mut Sampler::named("test", seed));
            let mut sampler = Sampler::named("test", seed);
            for (k, v) in v.into_iter().enumerate() {
                let (drawn, part) = (sampler.real(), v / if k < 3 { 0.5 } else { 8.0 });
                assert!((part / (1.0 - part.abs()) - drawn).abs() <= 1e-9 * (1.0 + drawn * drawn), "{drawn} {part}");
            }
        }
    }

    #[test]
    fn what_is_not_given_behind_the_products_is_not_needed() {
        let formula = find("slot.friction").unwrap();
        let options = verify::Options { samples: 10, ..verify::Options::default() };
        let asked = super::questions(formula, Wanted::Products, &options);
        let asked = along_directions(formula, &asked, 1);
        let court = Court {
            formula,
            wanted: Wanted::Products,
            bounds: super::super::verdict::Bounds::of(formula),
            questions: &asked,
            is_strict: false,
        };
        let answer = |question: &Question| {
            let [v, _] = question.directions.as_ref().unwrap();
            let (value, jacobian) = formula.value_and_jacobian(&question.inputs).unwrap();
            let product = jacobian.chunks(5).map(|row| row.iter().zip(v).map(|(slope, v)| slope * v).sum());
            Answer::Numbers(value.into_iter().chain(product).map(Some).chain([None; 5]).collect())
        };
        let message = message(&court, &asked.iter().map(answer).collect::<Vec<_>>()).unwrap();
        assert!(message.starts_with("J v are the derivatives of its own values along 6 directions"), "{message}");
    }

    #[test]
    fn what_would_leave_its_domain_stays() {
        let formula = find("slide_line.closest_smoothed_linear").unwrap();
        let mut x = formula.timing_inputs(&Options { timing_points: 1, ..Options::quick() });
        let fraction = x.len() - 1;
        // At the end of the domain, and where half of the longest step fits.
        for from in [0.5_f64.next_down(), 0.5 - 0.5 * STEPS[1] / 2.0] {
            x[fraction] = from;
            let (mut moves, mut stays) = (0, 0);
            for seed in 0..200 {
                let v = tangent(formula, &x, &mut Sampler::named("test", seed));
                let moved: Vec<_> = x.iter().zip(&v).map(|(x, v)| x + STEPS[0] * v).collect();
                assert!(formula.value_and_jacobian(&moved).is_ok(), "{moved:?}");
                assert!(v[..fraction].iter().all(|v| *v != 0.0));
                *(if v[fraction] == 0.0 { &mut stays } else { &mut moves }) += 1;
            }
            assert!(moves > 0 && stays > 0, "{moves} move, {stays} stay");
        }
    }
}
