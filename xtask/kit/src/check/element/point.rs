//! What a routine is given at a point, and what it should answer.

use crate::check::derivative::rotation;
use crate::check::random::Random;
use crate::uel::{Interface, is_rotation, len};
use jointproof::formula::Field;

impl Interface {
    /// The numbers of a line of input, and of its answer.
    pub(super) fn numbers(&self) -> [usize; 2] {
        let (n, states) = (self.ndofel(), self.svars());
        [self.nprops() + states + self.mcrd * self.nodes + n, n + n * n + states]
    }

    /// PROPS, SVARS, COORDS and U at inputs; nodes have turned by up to so much about each axis.
    pub(super) fn arguments(&self, inputs: &[f64], rubs: bool, turn: f64, random: &mut Random) -> Vec<f64> {
        let layout = &self.layout;
        let nodes = len(layout.nodes);
        let multipliers = &inputs[nodes..nodes + len(layout.multipliers)];
        let rest = &inputs[nodes + multipliers.len()..];
        let (start, rest) = rest.split_at(len(layout.start));
        let (contact, state) = if rubs { rest.split_at(len(layout.contact)) } else { (rest, rest) };
        let mut turns = Vec::new();
        let mut props = Vec::new();
        for triad in &self.triads {
            if self.mcrd == 3 {
                let theta = [(); 3].map(|()| turn * random.next());
                let back = rotation(theta.map(|component| -component));
                for &vector in triad {
                    props.extend(back.map(|row| (0..3).map(|k| row[k] * inputs[vector + k]).sum::<f64>()));
                }
                turns.push(theta.to_vec());
            } else {
                let angle = turn * random.next();
                let (sine, cosine) = angle.sin_cos();
                for &vector in triad {
                    let [x, y] = [inputs[vector], inputs[vector + 1]];
                    props.extend([cosine * x + sine * y, cosine * y - sine * x]);
                }
                turns.push(vec![angle]);
            }
        }
        props.extend(start);
        props.extend(if rubs { contact.to_vec() } else { vec![0.0; len(layout.contact)] });
        props.resize(self.nprops(), 0.0);
        let mut svars = if rubs { state.to_vec() } else { vec![0.0; len(layout.state)] };
        svars.resize(self.svars(), 0.0);
        let mut coords = Vec::new();
        let mut displaced = Vec::new();
        for &position in &self.positions {
            for &x in &inputs[position..position + self.mcrd] {
                // No rounding from COORDS to X.
                let part = [0.25, 0.5, 0.75, 1.25][random.below(4)];
                let from = if x == 0.0 { part } else { part * x.signum() * x.abs().log2().floor().exp2() };
                coords.push(from);
                displaced.push(x - from);
            }
        }
        coords.resize(self.mcrd * self.nodes, 0.625);
        let (mut displaced, mut turns) = (displaced.into_iter(), turns.into_iter());
        let mut u = Vec::new();
        for unknown in layout.unknowns {
            if is_rotation(unknown) {
                u.extend(turns.next().unwrap_or_else(|| vec![random.next(); unknown.len()]));
            } else {
                u.extend(displaced.by_ref().take(unknown.len()));
            }
        }
        u.extend(multipliers);
        [props, svars, coords, u].concat()
    }

    /// RHS, minus AMATRX, and SVARS, from the results of the element; `None` for what nobody says.
    pub(super) fn expected(&self, results: &[f64], rubs: bool) -> Vec<Option<f64>> {
        let [n, m, conditions] = [self.layout.unknowns, self.layout.multipliers, self.layout.residuals].map(len);
        let [rows, forces, stiffness] = [conditions, conditions + conditions * n, conditions + conditions * n + n];
        let by_multipliers = stiffness + n * n;
        let after = by_multipliers + n * m;
        let mut expected: Vec<_> = results[forces..stiffness].iter().chain(&results[..m]).copied().map(Some).collect();
        for row in 0..n {
            expected.extend(results[stiffness + row * n..][..n].iter().copied().map(Some));
            expected.extend(results[by_multipliers + row * m..][..m].iter().copied().map(Some));
        }
        for row in 0..m {
            expected.extend(results[rows + row * n..][..n].iter().copied().map(Some));
            expected.extend(vec![Some(0.0); m]);
        }
        if rubs {
            expected.extend(results[after..].iter().copied().map(Some));
        }
        expected.resize(self.numbers()[1], None);
        expected
    }

    /// The name of a number of the answer.
    pub(super) fn name(&self, place: usize) -> String {
        let n = self.ndofel();
        match place {
            place if place < n => format!("RHS({})", place + 1),
            place if place < n + n * n => format!("AMATRX({},{})", (place - n) / n + 1, (place - n) % n + 1),
            place => format!("SVARS({})", place - n - n * n + 1),
        }
    }

    /// What a number is, and of which fields its row and its column are.
    pub(super) fn block(&self, place: usize) -> (char, usize, usize) {
        let field_of = |lists: [&[Field]; 2], k: usize| {
            let fields = lists.into_iter().flatten().enumerate();
            fields.flat_map(|(k, field)| vec![k; field.len()]).nth(k).unwrap_or_default()
        };
        let (n, layout) = (self.ndofel(), &self.layout);
        let row = |k| field_of([layout.unknowns, layout.residuals], k);
        match place {
            place if place < n => ('R', row(place), 0),
            place if place < n + n * n => {
                let place = place - n;
                ('A', row(place / n), field_of([layout.unknowns, layout.multipliers], place % n))
            }
            place => ('S', field_of([layout.state, &[]], place - n - n * n), 0),
        }
    }

    /// Where the numbers begin that a number is compared with in size, and where they end: RHS, a row of AMATRX, or SVARS.
    pub(super) fn kind(&self, place: usize) -> std::ops::Range<usize> {
        let n = self.ndofel();
        match place {
            place if place < n => 0..n,
            place if place < n + n * n => (place / n * n)..(place / n * n + n),
            _ => n + n * n..self.numbers()[1],
        }
    }
}

/// A point with what is expected there, and how far rounding may lead from it.
pub(super) struct Point {
    pub(super) name: String,
    pub(super) arguments: Vec<f64>,
    /// By the element, and by what else is right where conditions are violated; see `WAYS`. None where it has to be refused.
    pub(super) expected: Vec<Vec<Option<f64>>>,
    pub(super) allowed: Vec<f64>,
}

impl Point {
    pub(super) fn must_be_refused(&self) -> bool {
        self.expected.is_empty()
    }

    /// The numbers that are off by more than is allowed.
    pub(super) fn off(&self, found: &[Option<f64>], way: usize) -> Vec<usize> {
        if self.must_be_refused() {
            return Vec::new();
        }
        let is_off = |&place: &usize| {
            let (Some(found), Some(expected)) = (found[place], self.expected[way][place]) else { return false };
            let is_within = (found - expected).abs() <= self.allowed[place];
            !is_within
        };
        (0..found.len()).filter(is_off).collect()
    }
}
