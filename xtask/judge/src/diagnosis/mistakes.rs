//! Every mistake that is looked for, the simplest first.

use super::change::{Change, changes};
use super::model::{Inputs, Link, Model, Powers, Scope, Textbook, Times, product};
use super::sample::Evidence;
use super::words::Words;
use super::{factors, inputs, permuted, symmetric};
use crate::question::Wanted;
use jointproof::toolkit::graph::{Binary, Node, Op, Unary};

/// So many results, those that are computed first, are tried in pairs.
const FIRST: usize = 300;

/// All mistakes in the order in which they are named.
pub(super) fn mistakes(evidence: &Evidence<'_>, book: Option<&Textbook>) -> Vec<Model> {
    let mut all = of_numbers(evidence);
    if evidence.court.wanted != Wanted::Products {
        all.extend(of_inputs(evidence));
        all.extend(book.into_iter().flat_map(|book| by_results(evidence, book)));
        all.extend(book.into_iter().flat_map(|book| of_operations(evidence, book)));
        all.extend(entries(evidence));
    }
    all
}

/// Wrong numbers that follow from the right ones.
fn of_numbers(evidence: &Evidence<'_>) -> Vec<Model> {
    let groups = factors::groups(evidence);
    // Different factors together are one statement, if they are few.
    let together = (2..=3).contains(&groups.len()).then(|| {
        let what = groups.iter().map(|(what, _)| what.as_str()).collect::<Vec<_>>().join("; ");
        (what, groups.iter().flat_map(|(_, map)| map.clone()).collect())
    });
    let moved = permuted::exchanges(evidence).into_iter().map(|(what, places)| {
        let changed = places.iter().enumerate().filter(|(place, from)| place != *from);
        (what, changed.map(|(place, &from)| (place, vec![(from, 1.0)])).collect::<Vec<_>>())
    });
    let symmetric = if evidence.court.wanted == Wanted::Products { Vec::new() } else { symmetric::parts(evidence) };
    let [value, rest] = evidence.parts();
    let turned = |what: &str, places: std::ops::Range<usize>| {
        let map: Vec<_> = places.map(|place| (place, vec![(place, -1.0)])).collect();
        (format!("wrong sign: {what}"), map)
    };
    // These are looked for in any case, since beside other mistakes no number is a multiple of the right one.
    let signs = [("the whole Jacobian", rest), ("the whole value", value)];
    let signs = signs.into_iter().filter(|(_, places)| !places.is_empty()).map(|(what, places)| turned(what, places));
    let all = groups.into_iter().chain(together).chain(signs).chain(moved).chain(symmetric);
    all.map(|(what, map)| Model { maps: vec![map], ..Model::new(what) }).collect()
}

fn of_inputs(evidence: &Evidence<'_>) -> Vec<Model> {
    let has_jacobian = evidence.court.wanted == Wanted::Jacobian;
    let model = |(what, from, is_single): (String, Vec<(usize, f64)>, bool)| {
        let of = move |by_given| {
            let inputs = Inputs { from: from.clone(), is_single, by_given };
            Model { inputs: Some(inputs), ..Model::new(what.clone()) }
        };
        [true, false].into_iter().filter(move |by_given| has_jacobian || !by_given).map(of)
    };
    inputs::others(evidence.court.formula.inputs()).into_iter().flat_map(model).collect()
}

/// Single entries that hold another entry, or its opposite.
fn entries(evidence: &Evidence<'_>) -> Vec<Model> {
    let mut all = Vec::new();
    for &place in &evidence.off {
        let samples = evidence.off_samples(&[place]);
        let part = evidence.parts().into_iter().find(|part| part.contains(&place)).unwrap_or_default();
        let fits = |&(from, sign): &(usize, f64)| {
            from != place
                && samples.len() >= 3
                && samples.iter().any(|sample| sample.right[from] != 0.0)
                && evidence.nearly_all(|sample| sample.fits(place, sample.right[from] * sign))
        };
        if let Some((from, sign)) = part.flat_map(|from| [(from, 1.0), (from, -1.0)]).find(fits) {
            let names = &evidence.names;
            let minus = if sign < 0.0 { "−" } else { "" };
            let what = format!("an index is wrong: {} holds {minus}{}", names[place], names[from]);
            all.push(Model { maps: vec![vec![(place, vec![(from, sign)])]], ..Model::new(what) });
        }
    }
    all
}

/// Wrong numbers that are right ones times a power of a result of the formula.
fn by_results(evidence: &Evidence<'_>, book: &Textbook) -> Vec<Model> {
    let numbers = numbers(book);
    let powers = numbers.iter().flat_map(|node| [1, -1, 2, -2].map(|power| vec![(*node, power)]));
    by_powers(evidence, book, &powers.collect::<Vec<_>>())
}

/// The same with a product or a quotient of two results. Nearly everything is one of something, so this is looked for last.
pub(super) fn by_two_results(evidence: &Evidence<'_>, book: &Textbook) -> Vec<Model> {
    let mut numbers = numbers(book);
    numbers.truncate(FIRST);
    let length: Vec<_> = numbers.iter().map(|node| book.graph.needed(&[*node]).len()).collect();
    let mut pairs: Vec<_> = (0..numbers.len()).flat_map(|b| (0..b).map(move |a| (a, b))).collect();
    // The shortest expression of a product is its name.
    pairs.sort_by_key(|&(a, b)| length[a] + length[b]);
    let powers = pairs
        .into_iter()
        .flat_map(|(a, b)| [[1, -1], [-1, 1], [1, 1], [-1, -1]].map(|[p, q]| vec![(numbers[a], p), (numbers[b], q)]));
    by_powers(evidence, book, &powers.collect::<Vec<_>>())
}

/// The results of a formula that are no literals, and not those of comparisons.
fn numbers(book: &Textbook) -> Vec<Node> {
    let is_number = |node: &Node| !matches!(book.graph.op(*node), Op::Compare(..) | Op::Number(_) | Op::Select(..));
    book.needed.iter().copied().filter(is_number).collect()
}

/// Wrong numbers that are right ones times one of these products.
fn by_powers(evidence: &Evidence<'_>, book: &Textbook, known: &[Powers]) -> Vec<Model> {
    let words = Words::new(evidence.court.formula, book, &evidence.samples);
    let samples = evidence.off_samples(&evidence.off);
    let results: Vec<Vec<f64>> = samples.iter().map(|sample| book.results(&sample.inputs)).collect();
    let mut groups: Vec<(Powers, Vec<usize>)> = Vec::new();
    for &place in &evidence.off {
        // The ratio tells most where the number is large.
        let ratio = |sample: &super::sample::Sample| {
            let is_large = sample.right[place].abs() > 1e-3 * sample.scale[place];
            is_large.then(|| Some(sample.found[place]? / sample.right[place])).flatten()
        };
        let ratios = samples.iter().zip(&results).filter_map(|(sample, all)| Some((ratio(sample)?, all.as_slice())));
        let ratios: Vec<_> = ratios.collect();
        if ratios.len() < 4 {
            continue;
        }
        let fits = |powers: &[(Node, i32)]| {
            ratios.iter().all(|(ratio, all)| (ratio - product(all, powers)).abs() <= 1e-7 * ratio.abs())
        };
        if let Some((_, places)) = groups.iter_mut().find(|(powers, _)| fits(powers)) {
            places.push(place);
            continue;
        }
        if let Some(powers) = known.iter().find(|powers| fits(powers)) {
            groups.push((powers.clone(), vec![place]));
        }
    }
    let model = |(powers, places): (Powers, Vec<usize>)| {
        let is_divided = powers.iter().all(|(_, power)| *power < 0);
        let turn = if is_divided { -1 } else { 1 };
        let power = |&(node, power): &(Node, i32)| {
            let name = words.name(node);
            let name = if power.abs() == 2 { format!("the square of {name}") } else { name };
            (name, power * turn > 0)
        };
        let (above, below): (Vec<_>, Vec<_>) = powers.iter().map(power).partition(|(_, is_above)| *is_above);
        let names = |of: Vec<(String, bool)>| of.into_iter().map(|(name, _)| name).collect::<Vec<_>>().join(" times ");
        let below = if below.is_empty() { String::new() } else { format!(" over {}", names(below)) };
        let name = names(above) + &below;
        let factor = if is_divided {
            format!("divided by {name} too often, or not multiplied by it")
        } else {
            format!("multiplied by {name} too often, or not divided by it")
        };
        let whose = factors::whose(evidence, &places.iter().copied().collect());
        Model { scaled: vec![(places, powers)], ..Model::new(format!("{factor}: {whose}")) }
    };
    groups.into_iter().map(model).collect()
}

/// A factor in an operation, from the numbers themselves.
pub(super) fn fitted(evidence: &Evidence<'_>, book: &Textbook) -> Vec<Model> {
    let words = Words::new(evidence.court.formula, book, &evidence.samples);
    let [value, rest] = evidence.parts();
    let samples = evidence.off_samples(&evidence.off);
    let largest = |sample: &super::sample::Sample| {
        let all = evidence.off.iter().filter_map(|&place| sample.deviation(place));
        all.filter(|deviation| deviation.is_finite()).fold(0.0, f64::max)
    };
    // Where most is wrong the factor is known best.
    let most = samples.iter().take(40).max_by(|a, b| largest(a).total_cmp(&largest(b)));
    let Some(sample) = most.copied() else { return Vec::new() };
    let is_off = |part: &std::ops::Range<usize>| part.clone().find(|place| sample.is_off(*place));
    let (scopes, place): (&[Scope], usize) = match (is_off(&value), is_off(&rest)) {
        (Some(place), Some(_)) => (&[Scope::All, Scope::Used, Scope::Value], place),
        (Some(place), None) => (if rest.is_empty() { &[Scope::All] } else { &[Scope::Value] }, place),
        (None, Some(place)) => (&[Scope::Jacobian], place),
        (None, None) => return Vec::new(),
    };
    let mut all = Vec::new();
    for &node in book.needed.iter().rev() {
        let op = book.graph.op(node);
        if matches!(op, Op::Compare(..) | Op::Select(..)) {
            continue;
        }
        for &scope in scopes {
            let with = |factor: f64| Model {
                changes: vec![(node, Change::Times(factor))],
                scope,
                ..Model::new(String::new())
            };
            let found = sample.found[place].unwrap_or(f64::NAN);
            let off = |factor: f64| with(factor).predicted(Some(book), evidence.court.formula, sample)[place] - found;
            let Some(factor) = root(off) else { continue };
            let what = match op {
                Op::Number(bits) => {
                    let own = f64::from_bits(*bits);
                    let other = own * factor;
                    if (factor - 1.0).abs() < 2e-7 {
                        format!("the constant {own} has single precision, or {other} stands for it")
                    } else {
                        format!("{} for the constant {own}", super::wording::short(other))
                    }
                }
                _ => match factors::word(factor) {
                    Some(word) => format!("{word} {{}}"),
                    None => continue,
                },
            };
            let what = words.fill(&what, node, scope, rest.is_empty());
            all.push(Model { what: vec![what], ..with(factor) });
        }
    }
    all
}

/// The factor at which a function of it vanishes, by secants from 1; `None` if there is none nearby.
fn root(f: impl Fn(f64) -> f64) -> Option<f64> {
    let (mut a, mut b) = (1.0, 1.001);
    let (mut at_a, mut at_b) = (f(a), f(b));
    for _ in 0..12 {
        let next = b - at_b * (b - a) / (at_b - at_a);
        if !next.is_finite() || (next - b).abs() <= 1e-13 * next.abs() {
            break;
        }
        (a, at_a) = (b, at_b);
        (b, at_b) = (next, f(next));
        if at_b == 0.0 {
            break;
        }
    }
    let is_root = at_b.is_finite() && at_b.abs() <= 1e-4 * f(1.0).abs();
    is_root.then_some(b)
}

/// Mistakes in the operations of the formula, and in their derivatives.
fn of_operations(evidence: &Evidence<'_>, book: &Textbook) -> Vec<Model> {
    let words = Words::new(evidence.court.formula, book, &evidence.samples);
    let [value, rest] = evidence.parts();
    let is_off = |part: &std::ops::Range<usize>| evidence.off.iter().any(|place| part.contains(place));
    let scopes: &[Scope] = match (is_off(&value), is_off(&rest), rest.is_empty()) {
        (_, _, true) => &[Scope::All],
        (true, true, _) => &[Scope::All, Scope::Used, Scope::Value, Scope::Jacobian],
        (true, false, _) => &[Scope::Value],
        (false, ..) => &[Scope::Jacobian],
    };
    let mut all = Vec::new();
    let groups = words.families();
    for &scope in scopes {
        let one = |place: Node, change: Change, template: &str| {
            let what = words.fill(template, place, scope, rest.is_empty());
            Model { changes: vec![(place, change)], scope, ..Model::new(what) }
        };
        for &place in book.needed.iter().rev() {
            let op = book.graph.op(place);
            for (change, template) in changes(op) {
                all.push(one(place, change, &template));
            }
            if scope == Scope::Jacobian && matches!(op, Op::Compare(..)) {
                all.extend(branches_by_input(evidence, &words, place));
            }
            for (k, other) in words.others(place) {
                let own = op.operands()[k];
                let template = match book.graph.op(own) {
                    Op::Binary(Binary::Multiply, x, y) if x == y && *x == other => {
                        format!("the square of {} is forgotten in {{}}", words.name(other))
                    }
                    _ => format!("{} for {} in {{}}", words.name(other), words.name(own)),
                };
                all.push(one(place, Change::Instead(k, other), &template));
            }
            if let Some(x) = words.sign_of(place) {
                for width in super::change::SMALL.into_iter().chain([0.1, 1.0]) {
                    let template = format!("tanh({} / {width:e}) for the sign of {0}", words.name(x));
                    all.push(one(place, Change::Smooth(x, width), &template));
                }
            }
            if !matches!(op, Op::Input(_) | Op::Number(_) | Op::Compare(..) | Op::Select(..)) {
                all.push(one(place, Change::Times(0.0), "{} is left out"));
            }
        }
        if matches!(scope, Scope::Used | Scope::Value) || rest.is_empty() {
            for (a, b) in words.pairs() {
                let changes = vec![(a, Change::Value(b)), (b, Change::Value(a))];
                let what = format!("exchanged: {} and {}", words.name(a), words.name(b));
                all.push(Model { changes, scope, ..Model::new(what) });
            }
        }
        for group in &groups {
            let first = group[0];
            let op = book.graph.op(first);
            let without = (Change::Times(0.0), "{} is left out".to_owned());
            for (change, template) in changes(op).into_iter().chain([without]) {
                let what = words.fill(&template, first, scope, rest.is_empty());
                let what = format!("{what}, and so in all {} like it", group.len());
                let changes = group.iter().map(|place| (*place, change)).collect();
                all.push(Model { changes, scope, ..Model::new(what) });
            }
            for (what, k, nodes) in words.other_fields(group) {
                let what = words.fill(
                    &format!("{what} in {{}}, and so in all {} like it", group.len()),
                    first,
                    scope,
                    rest.is_empty(),
                );
                let changes = group.iter().zip(nodes).map(|(place, node)| (*place, Change::Instead(k, node))).collect();
                all.push(Model { changes, scope, ..Model::new(what) });
            }
        }
    }
    if is_off(&rest) {
        all.extend(links(book, &words, &groups));
    }
    all
}

/// Derivatives of one branch for all, by a single input.
fn branches_by_input(evidence: &Evidence<'_>, words: &Words<'_>, place: Node) -> Vec<Model> {
    let inputs = crate::scale::placed(evidence.court.formula.inputs());
    let (m, n) = (evidence.parts()[0].len(), inputs.iter().map(|(field, _)| field.len()).sum::<usize>());
    let mut all = Vec::new();
    for (change, template) in changes(&Op::Compare(jointproof::toolkit::graph::Relation::Less, place, place)) {
        for (field, columns) in &inputs {
            let only = (0..m).flat_map(|i| columns.clone().map(move |j| m + i * n + j)).collect();
            let what = words.fill(&template, place, Scope::Jacobian, false);
            let what = format!("{what}, in the derivatives with respect to {}", field.name);
            all.push(Model { changes: vec![(place, change)], scope: Scope::Jacobian, only, ..Model::new(what) });
        }
    }
    all
}

/// Mistakes in the derivatives of operations: left out, with another factor, not divided by something.
fn links(book: &Textbook, words: &Words<'_>, groups: &[Vec<Node>]) -> Vec<Model> {
    let mut all = Vec::new();
    let factors =
        [(0.0, "is left out"), (-1.0, "has the wrong sign"), (2.0, "is twice as large"), (0.5, "is half as large")];
    for &of in book.needed.iter().rev() {
        let op = book.graph.op(of);
        if matches!(op, Op::Input(_) | Op::Number(_) | Op::Compare(..) | Op::Select(..)) {
            continue;
        }
        let (operands, whole) = (op.operands(), words.name(of));
        let mut seen: Vec<Node> = operands.clone();
        seen.dedup();
        let link = |by: Option<Node>, times: Times, what: String| Model {
            links: vec![Link { of, by, times }],
            ..Model::new(what)
        };
        for &by in seen.iter().filter(|by| book.graph.constant(**by).is_none()) {
            for (factor, what) in factors {
                let what = format!("the derivative of {whole} with respect to {} {what}", words.name(by));
                all.push(link(Some(by), Times::Number(factor), what));
            }
        }
        if seen.len() > 1 {
            for (factor, what) in factors {
                all.push(link(None, Times::Number(factor), format!("the derivative of {whole} {what}")));
            }
        }
        match op {
            Op::Norm(_) | Op::Unary(Unary::Root, _) => {
                let what = format!("the derivative of {whole} is not divided by it");
                all.push(link(None, Times::Result(of, 1), what));
            }
            Op::Unary(Unary::Absolute, x) => {
                let of_x = words.name(*x);
                all.push(link(
                    None,
                    Times::Sign(*x),
                    format!("the sign of {of_x} is left out in the derivative of {whole}"),
                ));
                for width in super::change::SMALL.into_iter().chain([0.1, 1.0]) {
                    let what = format!("tanh({of_x} / {width:e}) for the sign of {of_x} in the derivative of {whole}");
                    all.push(link(None, Times::Tanh(*x, width), what));
                }
            }
            Op::Binary(Binary::Divide, _, y) => {
                let by = words.name(*y);
                all.push(link(
                    Some(*y),
                    Times::Result(*y, 1),
                    format!("the derivative of {whole} with respect to {by} is not divided by its square"),
                ));
                all.push(link(None, Times::Result(*y, 1), format!("the derivative of {whole} is not divided by {by}")));
            }
            Op::Binary(Binary::Angle, y, x) => {
                let (y_name, x_name) = (words.name(*y), words.name(*x));
                let what = format!(
                    "the derivative of {whole} is not divided by the sum of the squares of {y_name} and {x_name}"
                );
                all.push(link(None, Times::Squares(*y, *x), what));
            }
            _ => {}
        }
    }
    for group in groups {
        let operands = |of: &Node| book.graph.op(*of).operands();
        let name = words.name(group[0]);
        let of_all = |by: Option<usize>, factor: f64, what: String| {
            let link = |of: &Node| Link { of: *of, by: by.map(|k| operands(of)[k]), times: Times::Number(factor) };
            Model { links: group.iter().map(link).collect(), ..Model::new(what) }
        };
        for (factor, what) in factors {
            all.push(of_all(
                None,
                factor,
                format!("the derivative of {name} {what}, and so in all {} like it", group.len()),
            ));
            let count = operands(&group[0]).len();
            for k in (0..count).filter(|_| count > 1) {
                let by = words.name(operands(&group[0])[k]);
                let what = format!(
                    "the derivative of {name} with respect to {by} {what}, and so in all {} like it",
                    group.len()
                );
                all.push(of_all(Some(k), factor, what));
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::Answer;
    use crate::question::of_points;
    use crate::verdict::{Bounds, Court};
    use jointproof::catalog::find;

    /// The Jacobian of every mistaken program is the derivative of its values.
    #[test]
    fn derivatives_follow_from_mistakes() {
        let formulas: [(&str, &[f64]); 3] = [
            ("slot.friction", &[-7.0, 3.0, 4.5, -1.5, 0.3]),
            ("interaction.pressure_exponential", &[0.1, 0.7, 1.3]),
            ("slider.line", &[0.3, -0.7, 1.1, 2.3, 0.9, -1.7]),
        ];
        let mut looked = 0;
        for (id, at) in formulas {
            let formula = find(id).unwrap();
            let questions = of_points(formula, Wanted::Jacobian, vec![("random 0".into(), at.to_vec())], 1);
            let court = Court {
                formula,
                wanted: Wanted::Jacobian,
                bounds: Bounds::of(formula),
                questions: &questions,
                is_strict: false,
            };
            let wrong = questions[0].right(formula, Wanted::Jacobian).unwrap().iter().map(|x| Some(x + 1.0)).collect();
            let evidence = Evidence::new(&court, &[Answer::Numbers(wrong)], 0..1);
            let book = Textbook::of(formula, &evidence.samples).unwrap();
            let m = book.graph.value.len();
            for model in of_operations(&evidence, &book)
                .iter()
                .filter(|model| model.scope == Scope::All && model.links.is_empty())
            {
                let value = |k: usize, step: f64| {
                    let mut sample = evidence.samples[0].clone();
                    sample.inputs[k] += step;
                    model.predicted(Some(&book), formula, &sample)
                };
                let here = value(0, 0.0);
                for k in 0..at.len() {
                    let (above, below) = (value(k, 1e-6), value(k, -1e-6));
                    for i in 0..m {
                        let (slope, found) = ((above[i] - below[i]) / 2e-6, here[m + i * at.len() + k]);
                        let is_near = (slope - found).abs() <= 1e-6 * (1.0 + slope.abs() + here[i].abs());
                        assert!(is_near || !slope.is_finite(), "{id}, {:?}: {slope} {found}", model.what);
                        looked += usize::from(slope.is_finite());
                    }
                }
            }
        }
        assert!(looked > 5000, "{looked}");
    }
}
