//! Searches in planted formulas with known points and jumps.

use super::super::planted::{Function, graph, kink, only_where, planted};
use super::*;
use crate::formula::proof::Case;
use crate::toolkit::graph::Binary::{Add, Angle, Multiply, Subtract};
use crate::toolkit::graph::{Relation, Unary};
use num_dual::DualNum;
use num_traits::{Signed, Zero};
use serde_json::json;

/// x and y, which are smooth.
const SMOOTH_VALUE: Function = |i| vec![i[0], i[1]];
const SMOOTH_SLOPE: Function = |_| exact(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);

fn number(x: f64) -> Octuple {
    x.into()
}

/// −1, 0 and 1.
fn sign(x: Octuple) -> f64 {
    x.to_f64().partial_cmp(&0.0).map_or(0.0, |order| f64::from(order as i8))
}

fn smooth() -> Subject {
    planted(SMOOTH_VALUE, SMOOTH_SLOPE)
}

/// |x − 1| and 0.
fn bent() -> Subject {
    let value: Function = |i| vec![(i[0] - 1.0).abs(), number(0.0)];
    planted(value, |i| exact(&[sign(i[0] - 1.0), 0.0, 0.0, 0.0, 0.0, 0.0]))
}

/// Compares x with 1.
fn at_one() -> Graph {
    graph(|graph, [x, ..]| {
        let one = graph.number(1.0);
        vec![graph.compare(Relation::Less, x, one)]
    })
}

/// Compares x with 1 and y with 3.
fn at_one_and_three() -> Graph {
    graph(|graph, [x, y, _]| {
        let [one, three] = [1.0, 3.0].map(|c| graph.number(c));
        [(x, one), (y, three)].map(|(node, c)| graph.compare(Relation::Less, node, c)).into()
    })
}

/// Finds the points on the candidate with these words.
fn points_where(subject: &Subject, graph: &Graph, words: &str, starts: &[[f64; 3]]) -> Vec<Vec<Octuple>> {
    let names = Names::new(subject);
    let candidates = candidates(subject, graph, &names);
    let is_it = |candidate: &&Candidate| candidate.words == words;
    let candidate = candidates.iter().find(is_it).unwrap_or_else(|| panic!("{words} is none"));
    let starts: Vec<_> = starts.iter().map(|start| start.to_vec()).collect();
    Looking::new(subject, graph, &names).points_on(candidate, &starts)
}

/// The points where x = 1.
fn points_at_one(subject: &Subject, starts: &[[f64; 3]]) -> Vec<Vec<f64>> {
    points_where(subject, &at_one(), "x = 1", starts).iter().map(|at| rounded(at)).collect()
}

#[test]
fn three_points_are_enough_and_each_counts_once() {
    let starts = [1.0, 1.0, 2.0, 3.0, 4.0].map(|y| [5.0, y, 1.0]);
    assert_eq!(points_at_one(&smooth(), &starts), [[1.0, 1.0, 1.0], [1.0, 2.0, 1.0], [1.0, 3.0, 1.0]]);
    assert_eq!(points_at_one(&smooth(), &starts[..2]), [[1.0, 1.0, 1.0]]);
}

#[test]
fn fourteen_starts_are_tried() {
    let mut subject = smooth();
    subject.check = |i| only_where(i[1] == 3.0);
    let after = |others: usize| {
        let starts = [vec![[5.0, 1.0, 1.0]; others], vec![[5.0, 3.0, 1.0]]].concat();
        points_at_one(&subject, &starts)
    };
    assert_eq!(after(13), [[1.0, 3.0, 1.0]]);
    assert!(after(14).is_empty());
}

/// Inputs are valid if c is not that of a start.
#[test]
fn a_point_between_starts_is_looked_for_where_none_of_them_leads_to_one() {
    let starts = [[0.0, 1.0, 1.0], [8.0, 2.0, 5.0]];
    // If starts lead to points, no other one is sought.
    assert_eq!(points_at_one(&smooth(), &starts), [[1.0, 1.0, 1.0], [1.0, 2.0, 5.0]]);
    let mut subject = smooth();
    subject.check = |i| only_where(1.0 < i[2] && i[2] < 5.0);
    let [at] = &points_at_one(&subject, &starts)[..] else { panic!("there is one") };
    assert!(at[0] == 1.0 && (at[2] - 1.5).abs() < 1e-12, "{at:?}");
    assert!(points_at_one(&subject, &starts[..1]).is_empty());
    // With several equalities, none tells on which side a start is.
    let both = graph(|graph, [x, y, _]| {
        let [one, three] = [1.0, 3.0].map(|c| graph.number(c));
        let parts = [(x, one), (y, three)].map(|(node, c)| graph.binary(Subtract, node, c));
        vec![graph.enter(Op::Norm(parts.into()))]
    });
    let words = "|(x − 1, y − 3)| = 0";
    assert_eq!(points_where(&smooth(), &both, words, &starts)[0], exact(&[1.0, 3.0, 1.0]));
    assert!(points_where(&subject, &both, words, &starts).is_empty());
}

/// x (3 x − 1), with or without y − 2 alongside.
fn with_roots(is_alone: bool) -> Graph {
    graph(|graph, [x, y, _]| {
        let [one, two, three] = [1.0, 2.0, 3.0].map(|c| graph.number(c));
        let product = graph.binary(Multiply, three, x);
        let other = graph.binary(Subtract, product, one);
        let product = graph.binary(Multiply, x, other);
        let parts = [product, graph.binary(Subtract, y, two)];
        vec![if is_alone { graph.unary(Unary::Absolute, product) } else { graph.enter(Op::Norm(parts.into())) }]
    })
}

/// The first component of the points where x (3 x − 1) = 0 from a start. The root 1/3 is not a double.
fn roots(subject: &Subject, is_alone: bool, start: f64) -> Vec<f64> {
    let words = if is_alone { "x (3 x − 1) = 0" } else { "|(x (3 x − 1), y − 2)| = 0" };
    let found = points_where(subject, &with_roots(is_alone), words, &[[start, 2.0, 1.0]]);
    found.iter().map(|at| at[0].to_f64()).collect()
}

#[test]
fn where_a_place_is_refused_only_the_formula_can_say_what_is_valid() {
    let third = [1.0 / 3.0];
    let (mut subject, nothing) = (smooth(), [0.0; 0]);
    subject.is_valid = |_| false;
    // An invalid case elsewhere has no effect.
    subject.invalid_cases = || vec![Case::hard("elsewhere", "", vec![5.0, 2.0, 1.0])];
    assert_eq!([true, false].map(|is_alone| roots(&subject, is_alone, 1.0)), [third; 2]);
    subject.invalid_cases = || [5.0, 0.0].map(|x| Case::hard("refused", "", vec![x, 2.0, 1.0])).into();
    // At a double, the formula itself is asked.
    assert_eq!([true, false].map(|is_alone| roots(&subject, is_alone, -1.0)), [[0.0]; 2]);
    assert_eq!([true, false].map(|is_alone| roots(&subject, is_alone, 1.0)), [nothing; 2]);
    // A single equality may also hold at other points.
    subject.is_valid = |_| true;
    assert_eq!((roots(&subject, true, 1.0), roots(&subject, false, 1.0)), (third.into(), Vec::new()));
    subject.check = |_| only_where(false);
    assert_eq!([1.0, -1.0].map(|start| roots(&subject, true, start)), [nothing; 2]);
}

#[test]
fn a_point_is_on_the_side_that_is_negative() {
    let angle = graph(|graph, [x, y, _]| vec![graph.binary(Angle, y, x)]);
    let found = |x| points_where(&smooth(), &angle, "y = 0, x < 0", &[[x, 1.0, 1.0]]);
    assert_eq!(found(-3.0), [exact(&[-3.0, 0.0, 1.0])]);
    assert!([0.0, 0.5, 3.0].iter().all(|&x| found(x).is_empty()));
}

#[test]
fn the_value_depends_on_the_candidate_at_a_point() {
    let choice = graph(|graph, [x, y, c]| {
        let two = graph.number(2.0);
        let (condition, size) = (graph.compare(Relation::Less, y, two), graph.unary(Unary::Absolute, x));
        vec![graph.select(condition, size, c)]
    });
    let found = |y| points_where(&smooth(), &choice, "x = 0", &[[5.0, y, 1.0]]);
    assert_eq!(found(1.0), [exact(&[0.0, 1.0, 1.0])]);
    assert!(found(3.0).is_empty());
}

#[test]
fn both_sides_of_a_point_must_be_valid() {
    let (mut subject, graph) = (smooth(), at_one());
    let mut is_valid_beside = |is_valid| {
        subject.is_valid = is_valid;
        let names = Names::new(&subject);
        Looking::new(&subject, &graph, &names).is_valid_beside(&exact(&[2.0; 3]))
    };
    let valid: [fn(&[Octuple]) -> bool; 4] = [|i| i[0] != 2.0, |i| i[0] < 2.0, |i| i[0] > 2.0, |i| i[0] == 2.0];
    assert_eq!(valid.map(&mut is_valid_beside), [true, false, false, false]);
}

#[test]
fn a_candidate_depends_on_the_inputs_that_it_is_computed_from() {
    let mut product = Graph::default();
    let [x, _, c] = product.inputs();
    let node = product.binary(Multiply, c, x);
    let (subject, candidate) = (smooth(), at(node));
    let names = Names::new(&subject);
    assert_eq!(Looking::new(&subject, &product, &names).inputs_of(&candidate), [0, 2]);
}

/// A candidate of which only the operation and the words matter.
fn at(node: Node) -> Candidate {
    Candidate { node, words: "there".into(), pairs: Vec::new(), negative: None }
}

/// Queries the jumps at a point.
fn jumps<T>(subject: &Subject, point: [f64; 3], ask: impl FnOnce(&mut Looking<'_>, &Neighbourhood<'_>) -> T) -> T {
    let (graph, names, point) = (at_one(), Names::new(subject), exact(&point));
    ask(&mut Looking::new(subject, &graph, &names), &Neighbourhood::new(subject, &point))
}

/// For |x| + 3 y, whose closed form has 1 at x = 0: the sizes of x and c are 1, that of y is 2.
#[test]
fn the_larger_of_the_jumps_along_two_random_directions_counts() {
    let value: Function = |i| vec![i[0].abs() + i[1] * 3.0, i[1]];
    let subject = planted(value, |i| exact(&[if i[0] < 0.0 { -1.0 } else { 1.0 }, 0.0, 0.0, 0.0, 1.0, 0.0]));
    let mut draws = Sampler::for_formula(subject.spec.id, 0);
    jumps(&subject, [0.0, 2.0, 1.0], |looking, neighbourhood| {
        for _ in 0..8 {
            let [a, b] = [(); 2].map(|()| draws.number(Domain::Between(-1.0, 1.0)).abs());
            let jump = looking.jump(neighbourhood, &[0], false);
            let expected = 2.0 * a.max(b) / (2.0 * a.max(b) + 6.0 + 1.0);
            assert!((jump.size - expected).abs() < 1e-12, "{jump:?} {expected}");
        }
    });
}

/// (x − 1) (y − 2)² / ((x − 1)² + (y − 2)²), which is linear along every direction.
fn odd() -> Subject {
    fn parts(i: &[Octuple]) -> [Octuple; 3] {
        let [u, v] = [i[0] - 1.0, i[1] - 2.0];
        [u, v, u * u + v * v]
    }
    let value: Function = |i| {
        let [u, v, square] = parts(i);
        vec![number(0.0), if square.is_zero() { square } else { u * v * v / square }]
    };
    planted(value, |i| {
        let [u, v, square] = parts(i);
        let slopes = [v * v * (v * v - u * u), u * u * u * v * 2.0].map(|slope| slope / (square * square));
        [exact(&[0.0; 3]), slopes.into(), exact(&[0.0])].concat()
    })
}

#[test]
fn where_several_numbers_vanish_slopes_along_directions_must_add_up() {
    let is_smooth = |inputs: &[usize], is_point| {
        jumps(&odd(), [1.0, 2.0, 1.0], |looking, beside| looking.jump(beside, inputs, is_point).is_smooth())
    };
    assert_eq!([true, false].map(|is_point| is_smooth(&[0, 1], is_point)), [false, true]);
    assert!(is_smooth(&[0], true));
}

/// 1 to the right and 1.1 to the left: the slopes of two directions nearly cancel, but not those of a single one.
#[test]
fn directions_of_a_single_input_need_not_add_up() {
    let value: Function = |i| vec![(i[0] - 1.0) * if i[0] < 1.0 { 1.1 } else { 1.0 }, number(0.0)];
    let slope: Function = |i| {
        let slope = [1.1, 0.0, 1.0][usize::from(i[0] >= 1.0) + usize::from(i[0] > 1.0)];
        exact(&[slope, 0.0, 0.0, 0.0, 0.0, 0.0])
    };
    jumps(&planted(value, slope), [1.0, 2.0, 1.0], |looking, beside| {
        for _ in 0..20 {
            let jump = looking.jump(beside, &[0], true);
            assert!((jump.size - 0.1 / 2.1).abs() < 1e-12, "{jump:?}");
        }
    });
}

/// √y and √(4 − y).
fn at_edges() -> Subject {
    let value: Function = |i| vec![(number(4.0) - i[1]).sqrt(), i[1].sqrt()];
    planted(value, |i| {
        let [upper, lower] = [number(-0.5) / (number(4.0) - i[1]).sqrt(), number(0.5) / i[1].sqrt()];
        vec![number(0.0), upper, number(0.0), number(0.0), lower, number(0.0)]
    })
}

#[test]
fn at_the_edge_of_a_domain_the_slope_into_it_must_have_a_limit() {
    for (y, output) in [(0.0, 1), (4.0, 0)] {
        jumps(&at_edges(), [1.0, y, 1.0], |looking, beside| {
            let jump = looking.jump(beside, &[1], false);
            assert!(jump.size > 0.99 && jump.output == output, "{jump:?}");
            assert!(looking.jump(beside, &[0, 2], true).is_smooth());
        });
    }
}

/// The description of a jump of this size with respect to these inputs: the size, the entry, and both sides.
fn described(subject: &Subject, point: [f64; 3], inputs: &[usize], size: f64) -> (f64, String, [f64; 2]) {
    jumps(subject, point, |looking, _| {
        let jump = Jump { size, output: 1, sides: [2.0, 1.0].map(number) };
        let [x] = Graph::default().inputs();
        let Deviation { size, entry, point: place, found, expected, inputs } =
            looking.described(&at(x), &exact(&point), inputs, jump);
        assert_eq!(place, "where there");
        assert_eq!(inputs, json!({"x": point[0], "y": point[1], "c": point[2]}));
        (size, entry, [expected, found])
    })
}

/// 5 + 3 |x − 1| + 2 |y − 2|, or with 9 |x − 1|: y is twice as large as x.
#[test]
fn a_jump_is_shown_by_the_input_with_the_largest_one() {
    let slope: Function = |i| exact(&[0.0, 0.0, 0.0, sign(i[0] - 1.0) * 9.0, sign(i[1] - 2.0) * 2.0, 0.0]);
    let by_y: Function = |i| vec![number(0.0), (i[0] - 1.0).abs() * 3.0 + (i[1] - 2.0).abs() * 2.0 + 5.0];
    let by_x: Function = |i| vec![number(0.0), (i[0] - 1.0).abs() * 9.0 + (i[1] - 2.0).abs() * 2.0 + 5.0];
    let shown = |value, size| described(&planted(value, slope), [1.0, 2.0, 1.0], &[0, 1, 2], size);
    assert_eq!(shown(by_y, 0.25), (0.25, "∂b/∂y".into(), [-2.0, 2.0]));
    assert_eq!(shown(by_x, 0.25), (0.25, "∂b/∂x".into(), [-9.0, 9.0]));
    assert_eq!(shown(by_y, 0.0), (0.0, "∂b/∂y".into(), [-2.0, 2.0]));
}

#[test]
fn a_jump_at_an_edge_is_shown_over_the_longer_and_the_shorter_step() {
    for (y, of, unit) in [(0.0, "∂b/∂y", 1.0), (4.0, "∂a/∂y", -0.5)] {
        let (size, entry, [longer, shorter]) = described(&at_edges(), [1.0, y, 1.0], &[0, 1], 0.5);
        let is_near = (longer / unit - 1e12).abs() < 1e3 && (shorter / unit - 1e15).abs() < 1e6;
        assert!(size == 0.5 && entry == of && is_near, "{entry} {longer} {shorter}");
    }
}

#[test]
fn where_no_input_shows_a_jump_two_directions_do() {
    let sum = "∂b along the sum of two directions".to_owned();
    let shown = |inputs: &[usize], size| described(&odd(), [1.0, 2.0, 1.0], inputs, size);
    assert_eq!(shown(&[0, 1], 0.5), (0.5, sum.clone(), [2.0, 1.0]));
    assert_eq!(shown(&[], 0.0), (0.0, sum, [2.0, 1.0]));
    // If nothing jumps at all, any input shows that.
    let (_, entry, sides) = shown(&[0, 1], 0.0);
    assert!(entry.starts_with("∂a/∂") && sides == [0.0; 2], "{entry} {sides:?}");
}

#[test]
fn kinks_count_once_and_the_others_are_lacking() {
    let mut subject = smooth();
    subject.kinks = ["x = 1", "y = 1", "c = 1"].map(|condition| kink(condition, |_| false, [1.0; 3], [1.0; 3])).into();
    let mut search = Search::default();
    let met = |search: &mut Search, conditions: &[&str]| {
        search.met(conditions.iter().map(ToString::to_string).collect());
        (search.found.join(", "), search.lacks(&subject))
    };
    assert_eq!(met(&mut search, &[]), (String::new(), 3));
    assert_eq!(met(&mut search, &["y = 1"]), ("y = 1".into(), 2));
    assert_eq!(met(&mut search, &["x = 1", "y = 1"]), ("y = 1, x = 1".into(), 1));
}

#[test]
fn a_power_of_two_is_near_every_number_but_0() {
    assert_eq!([3.0, -3.0, 0.75, 4.0].map(power_of_two_near), [2.0, -2.0, 0.5, 4.0]);
    assert_eq!([0.0, -0.0].map(|x| power_of_two_near(x).to_bits()), [0.0, -0.0].map(f64::to_bits));
}

/// The results and claims of a search from points.
fn searched(subject: &Subject, graph: &Graph, points: &[[f64; 3]]) -> (Search, Claim) {
    let points: Vec<_> = points.iter().map(|at| Point::new(subject, "there".into(), true, at.to_vec())).collect();
    let mut claim = Claim::new("kinks are registered", SMOOTH);
    let search = search(subject, graph, &Names::new(subject), &points.iter().collect::<Vec<_>>(), &mut claim);
    (search, claim)
}

/// Candidates, points, smooth and registered candidates.
fn counts(search: &Search) -> [usize; 4] {
    [search.candidates, search.points, search.smooth, search.registered]
}

/// Points so simple that no simpler ones are near.
const THREE: [[f64; 3]; 3] = [[4.0, 1.0, 1.0], [4.0, 2.0, 1.0], [4.0, 4.0, 1.0]];

#[test]
fn a_candidate_at_which_nothing_jumps_is_smooth() {
    let (search, claim) = searched(&smooth(), &at_one(), &THREE);
    assert_eq!((counts(&search), search.not_reached.len(), search.found.len()), ([1, 3, 1, 0], 0, 0));
    assert_eq!((claim.checks, claim.failures), (3, 0));
}

#[test]
fn a_candidate_at_which_a_registered_kink_holds_is_registered() {
    let mut subject = bent();
    subject.kinks.push(kink("x = 1", |i| i[0] == 1.0, [1.0; 3], [1.0, 0.0, 0.0]));
    let (search, claim) = searched(&subject, &at_one(), &THREE);
    assert_eq!((counts(&search), search.not_reached.len()), ([1, 3, 0, 1], 0));
    assert_eq!((search.found, claim.checks), (vec!["x = 1".to_owned()], 0));
}

#[test]
fn a_jump_that_is_not_registered_is_a_deviation() {
    let (search, claim) = searched(&bent(), &at_one(), &THREE);
    assert_eq!((counts(&search), claim.checks, claim.failures), ([1, 3, 0, 1], 3, 3));
    let worst = claim.worst.expect("it was checked");
    assert_eq!((worst.size, worst.entry.as_str(), worst.point.as_str()), (1.0, "∂a/∂x", "where x = 1"));
    assert_eq!((worst.expected, worst.found, worst.inputs), (-1.0, 1.0, json!({"x": 1.0, "y": 1.0, "c": 1.0})));
}

#[test]
fn a_candidate_on_which_no_point_was_found_is_named() {
    let mut subject = bent();
    subject.check = |i| only_where(i[0] != 1.0);
    let (search, claim) = searched(&subject, &at_one_and_three(), &THREE);
    // For y = 3 all starts lead to one point.
    assert_eq!((counts(&search), search.not_reached), ([2, 1, 1, 0], vec!["x = 1".to_owned()]));
    assert_eq!((claim.checks, claim.failures), (1, 0));
}

/// A kink only where y is above 3.
#[test]
fn a_single_point_at_which_something_jumps_is_enough() {
    let value: Function = |i| vec![if i[1] > 3.0 { (i[0] - 1.0).abs() } else { i[0] }, number(0.0)];
    let slope: Function = |i| exact(&[if i[1] > 3.0 { sign(i[0] - 1.0) } else { 1.0 }, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let mut subject = planted(value, slope);
    subject.kinks.push(kink(r"x = 1,\ y > 3", |i| i[0] == 1.0 && i[1] > 3.0, [1.0, 4.0, 1.0], [1.0, 0.0, 0.0]));
    for order in [[0, 1, 2], [2, 1, 0]] {
        let (search, claim) = searched(&subject, &at_one(), &order.map(|k| THREE[k]));
        assert_eq!((counts(&search), search.found.len(), claim.checks, claim.failures), ([1, 3, 0, 1], 1, 2, 0));
    }
}

/// Until it was met.
#[test]
fn a_kink_on_which_nothing_jumps_here_is_met_all_the_same() {
    let mut subject = smooth();
    subject.kinks.push(kink("x = 1", |i| i[0] == 1.0, [1.0; 3], [1.0, 0.0, 0.0]));
    let (search, claim) = searched(&subject, &at_one(), &THREE);
    assert_eq!((counts(&search), search.found.len(), claim.checks), ([1, 3, 1, 0], 1, 3));
    subject.kinks.push(kink("y = 9", |_| false, [1.0; 3], [1.0, 0.0, 0.0]));
    assert_eq!(searched(&subject, &at_one(), &THREE).0.found, ["x = 1"]);
}

#[test]
fn slopes_along_directions_must_add_up_where_several_numbers_vanish_alone() {
    let subject = odd();
    let failures = |is_point| {
        let at = graph(|graph, [x, y, _]| {
            let [one, two] = [1.0, 2.0].map(|c| graph.number(c));
            let [u, v] = [(x, one), (y, two)].map(|(node, c)| graph.binary(Subtract, node, c));
            let sum = graph.binary(Add, u, v);
            vec![if is_point { graph.enter(Op::Norm([u, v].into())) } else { graph.unary(Unary::Absolute, sum) }]
        });
        let (search, claim) = searched(&subject, &at, &[[1.0, 2.0, 1.0]]);
        assert_eq!(search.points, 1);
        claim.failures
    };
    assert_eq!([true, false].map(failures), [1, 0]);
}

/// The inputs x, y and c of the first point found, and the number of points.
fn first(subject: &Subject, graph: &Graph, points: &[[f64; 3]]) -> ([f64; 3], usize) {
    let (search, claim) = searched(subject, graph, points);
    let inputs = claim.worst.map(|worst| ["x", "y", "c"].map(|name| worst.inputs[name].as_f64().expect("a number")));
    (inputs.unwrap_or_default(), search.points)
}

#[test]
fn starts_of_single_digits_come_first() {
    assert_eq!(first(&smooth(), &at_one(), &[[5.5, 1.25, 3.75]]), ([1.0, 1.0, 2.0], 2));
    // The eighth simple start is the last.
    let mut subject = smooth();
    subject.check = |i| only_where(i[2] == 512.0);
    let points = |others: usize| [vec![[5.5, 1.25, 3.75]; others], vec![[5.5, 1.25, 700.0]]].concat();
    assert_eq!(first(&subject, &at_one(), &points(7)), ([1.0, 1.0, 512.0], 1));
    assert_eq!(first(&subject, &at_one(), &points(8)).1, 0);
}

#[test]
fn a_start_of_single_digits_is_valid_and_on_no_kink() {
    let y_is_one = graph(|graph, [_, y, _]| {
        let one = graph.number(1.0);
        vec![graph.compare(Relation::Less, y, one)]
    });
    let mut subject = smooth();
    assert_eq!(first(&subject, &y_is_one, &[[3.0, 3.0, 3.0]]), ([2.0, 1.0, 2.0], 2));
    subject.check = |i| only_where(i[1] != 2.0);
    assert_eq!(first(&subject, &y_is_one, &[[3.0, 3.0, 3.0]]), ([3.0, 1.0, 3.0], 1));
    subject.check = |_| Ok(());
    subject.kinks.push(kink("y = 2", |i| i[1] == 2.0, [1.0; 3], [1.0; 3]));
    assert_eq!(first(&subject, &y_is_one, &[[3.0, 3.0, 3.0]]), ([3.0, 1.0, 3.0], 1));
}

#[test]
fn points_on_a_kink_are_no_starts() {
    let mut subject = smooth();
    subject.kinks.push(kink("c = 8", |i| i[2] == 8.0, [1.0; 3], [1.0; 3]));
    assert_eq!(first(&subject, &at_one(), &[[4.0, 1.0, 8.0], [4.0, 2.0, 1.0]]), ([1.0, 2.0, 1.0], 1));
}

/// |x − 1| where c is 7, and |y − 3| where it is 9: 34 starts and the eight simple ones are three times fourteen.
#[test]
fn a_kink_that_no_first_point_met_is_looked_for_from_the_other_starts() {
    let points = |special: &[(usize, f64)]| {
        let point = |k| [4.0 + f64::from(k) / 64.0, f64::from(k) / 16.0, 1.0];
        let mut points: Vec<_> = (0_u8..34).map(point).collect();
        for &(k, c) in special {
            points[k][2] = c;
        }
        points
    };
    let mut subject = smooth();
    let found = |subject: &Subject, special: &[(usize, f64)]| {
        let (search, _) = searched(subject, &at_one_and_three(), &points(special));
        (search.points, search.found.join(", "))
    };
    // If nothing is missing, only the first points are used.
    assert_eq!(found(&subject, &[]), (3 + 3, String::new()));
    subject.kinks.push(kink(r"x = 1,\ c = 7", |i| i[0] == 1.0 && i[2] == 7.0, [1.0; 3], [1.0; 3]));
    let by_x = r"x = 1,\ c = 7";
    assert_eq!(found(&subject, &[(6, 7.0)]), (3 + 3 + 3, by_x.into()));
    assert_eq!(found(&subject, &[(20, 7.0)]), (3 + 3 + 6 + 3, by_x.into()));
    assert_eq!(found(&subject, &[]), (3 + 3 + 6 + 6, String::new()));
    subject.kinks.push(kink(r"y = 3,\ c = 9", |i| i[1] == 3.0 && i[2] == 9.0, [1.0; 3], [1.0; 3]));
    let both = format!(r"{by_x}, y = 3,\ c = 9");
    assert_eq!(found(&subject, &[(6, 7.0), (7, 9.0)]), (3 + 3 + 6, both.clone()));
    assert_eq!(found(&subject, &[(6, 7.0), (20, 9.0)]), (3 + 3 + 6 + 6, both));
}
