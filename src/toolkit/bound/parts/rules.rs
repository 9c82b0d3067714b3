//! The rules that serve to find a proof.

use super::{Atom, Inequality, Obstacle, Part, Parts, Rule, field};
use crate::toolkit::bound::field::{POINTS, Rational, Values};
use num_traits::One;
use std::collections::BTreeMap;

impl Parts<'_> {
    /// The rules that serve to find a proof.
    pub(in crate::toolkit::bound) fn rules(&mut self) -> BTreeMap<Rule, Inequality> {
        let mut names: Vec<Rule> = self.sizes.keys().map(|&(node, form)| Rule::Beside(node, form)).collect();
        let equations = std::mem::take(&mut self.equations);
        for equation in &equations {
            names.extend((0..equation.len()).map(|k| Rule::Sum(with_first(equation, k))));
            let values: Vec<_> = equation.iter().map(|&(_, part)| self.value(part).unwrap_or_default()).collect();
            for bounded in &self.signs.bounded {
                let pairs = (0..values.len()).flat_map(|k| (0..values.len()).map(move |other| (k, other)));
                let pairs = pairs.filter(|&(k, other)| k != other && values[k][0] != 0 && values[other][0] != 0);
                let is_range = |&(k, other): &(usize, usize)| bounded.most(&values[k], &values[other]).is_some();
                names.extend(
                    pairs.filter(is_range).map(|(k, other)| Rule::Range(equation[k].1, equation[other].1, bounded.by)),
                );
            }
        }
        let sums: Vec<_> = self.forms.iter().filter(|(node, _)| self.signs.adds_up(**node)).collect();
        names.extend(
            sums.into_iter().flat_map(|(&node, forms)| (0..forms.len()).map(move |form| Rule::Parts(node, form))),
        );
        let mut rules = BTreeMap::new();
        let mut add = |parts: &mut Self, names: Vec<Rule>| {
            for name in names {
                if let Ok(inequality) = parts.inequality(&name) {
                    rules.insert(name, inequality);
                }
            }
            parts.bounded(&rules)
        };
        let mut bounded = add(self, names);
        loop {
            let found =
                if self.fields.is_some() { self.spanned(&bounded) } else { self.eliminated(&equations, &bounded) };
            let more = add(self, found);
            if more == bounded {
                return rules;
            }
            bounded = more;
        }
    }

    /// Equations that follow from these, each for one part that is not bounded, in terms of bounded parts.
    fn eliminated(&mut self, equations: &[Vec<(Rational, Part)>], bounded: &[bool]) -> Vec<Rule> {
        type Row = BTreeMap<Atom, u64>;
        let is_open = |atom: Atom| !bounded.get(atom).copied().unwrap_or_default();
        let unknown = |row: &Row| row.keys().filter(|&&atom| is_open(atom)).count();
        let mut rows: Vec<Row> = Vec::new();
        for equation in equations {
            let mut row = Row::new();
            for &(sign, part) in equation {
                let Some((factor, atom)) = self.atom(part) else { continue };
                let factor = field::of_rational(sign * factor).unwrap_or_default();
                let entry = row.entry(atom).or_default();
                *entry = field::add(*entry, factor);
            }
            row.retain(|_, factor| *factor != 0);
            rows.extend(Some(row).filter(|row| unknown(row) > 0));
        }
        rows.sort_by_key(unknown);
        let mut solved: BTreeMap<Atom, Row> = BTreeMap::new();
        let subtract = |row: &mut Row, atom: Atom, other: &Row| {
            let Some(factor) = row.get(&atom).map(|factor| field::negative(*factor)) else { return };
            for (&atom, &of) in other {
                let entry = row.entry(atom).or_default();
                *entry = field::add(*entry, field::multiply(factor, of));
            }
            row.retain(|_, factor| *factor != 0);
        };
        for mut row in rows {
            for (&atom, other) in &solved {
                subtract(&mut row, atom, other);
            }
            let Some(atom) = row.keys().copied().find(|&atom| is_open(atom)) else { continue };
            let per_atom = field::inverse(row[&atom]).unwrap_or_default();
            let row: Row = row.into_iter().map(|(other, factor)| (other, field::multiply(factor, per_atom))).collect();
            for other in solved.values_mut() {
                subtract(other, atom, &row);
            }
            solved.insert(atom, row);
        }
        let named = |(atom, row): (Atom, Row)| {
            let first = (unknown(&row) == 1).then(|| (Rational::one(), self.first[atom].0))?;
            let others = row.iter().filter(|(other, _)| **other != atom);
            let others = others.map(|(&other, &factor)| Some((field::to_rational(factor)?, self.first[other].0)));
            Some(Rule::Sum(std::iter::once(Some(first)).chain(others).collect::<Option<_>>()?))
        };
        solved.into_iter().filter_map(named).collect()
    }

    /// Equations for parts that are not bounded, in terms of bounded parts: by the values at more points than there are such parts.
    fn spanned(&self, bounded: &[bool]) -> Vec<Rule> {
        let named = |is_bounded: bool| {
            let atoms = (0..self.count()).filter(move |&atom| bounded[atom] == is_bounded && self.first[atom].1 != 0);
            atoms.map(|atom| self.first[atom].0)
        };
        let mut parts: Vec<Part> = named(true).collect();
        let count = parts.len();
        parts.extend(named(false));
        let mut rows: Vec<(usize, Vec<u64>)> = Vec::new();
        for start in 1.. {
            let Ok(elsewhere) = self.elsewhere(start * POINTS as u64) else { return Vec::new() };
            let values: Vec<Values> = parts.iter().map(|&part| elsewhere.value(part).unwrap_or_default()).collect();
            let before = rows.len();
            for k in 0..POINTS {
                let mut row: Vec<u64> = values.iter().map(|values| values[k]).collect();
                for (pivot, other) in &rows {
                    field::subtract(&mut row, other, *pivot);
                }
                let Some(pivot) = row.iter().position(|&x| x != 0) else { continue };
                let unit = field::inverse(row[pivot]).unwrap_or_default();
                for x in &mut row {
                    *x = field::multiply(*x, unit);
                }
                for (_, other) in &mut rows {
                    field::subtract(other, &row, pivot);
                }
                rows.push((pivot, row));
            }
            if rows.len() == before {
                break;
            }
        }
        let equation = |place: usize| {
            let terms = rows.iter().filter(|(_, row)| row[place] != 0);
            let terms = terms.map(|&(pivot, ref row)| {
                let factor = field::to_rational(field::negative(row[place]))?;
                (pivot < count).then_some((factor, parts[pivot]))
            });
            Some(Rule::Sum(std::iter::once(Some((Rational::one(), parts[place]))).chain(terms).collect::<Option<_>>()?))
        };
        (count..parts.len()).filter_map(equation).collect()
    }

    /// Which parts can be moved on to inputs and to the result.
    fn bounded(&self, rules: &BTreeMap<Rule, Inequality>) -> Vec<bool> {
        let mut is_bounded = vec![false; self.count()];
        self.room.keys().for_each(|&atom| is_bounded[atom] = true);
        loop {
            let before = is_bounded.iter().filter(|is| **is).count();
            for rule in rules.values() {
                if rule.right.iter().all(|&(_, atom)| is_bounded[atom]) {
                    rule.left.iter().for_each(|&(_, atom)| is_bounded[atom] = true);
                }
            }
            if is_bounded.iter().filter(|is| **is).count() == before {
                return is_bounded;
            }
        }
    }

    /// The first operation whose rounding no rule moves on to an input or to the result.
    pub(in crate::toolkit::bound) fn obstacle(&self, rules: &BTreeMap<Rule, Inequality>) -> Option<Obstacle> {
        let is_bounded = self.bounded(rules);
        let missing = self.load.iter().filter(|(atom, _)| !is_bounded[**atom]).map(|(_, &(_, node))| node);
        missing.min().map(Obstacle::Rounding)
    }
}

/// The same equation with another term first.
fn with_first(equation: &[(Rational, Part)], k: usize) -> Vec<(Rational, Part)> {
    let mut terms = equation.to_vec();
    terms[..=k].rotate_right(1);
    terms
}
