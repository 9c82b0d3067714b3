//! An equation closed over its inputs: definitions from other entries are included, and symbols used once are
//! substituted.

use super::latex;
use super::name::Name;
use super::scope::Entries;
use super::syntax::{Body, Condition, Expr, Kind, Statement};

/// The statements of the equation and of those it refers to, each symbol defined once; `None` if two entries use one
/// symbol for different things.
pub(super) fn flat(entries: &Entries) -> Option<Vec<Statement>> {
    let mut all = Flat { entries, found: Vec::new() };
    for place in 0..entries.0[0].statements.len() {
        all.add(&[0], place, Vec::new())?;
    }
    let statement = |found: &Found| {
        let statement = &entries.0[found.entry].statements[found.place];
        let body = match &statement.body {
            Body::Equal(sides) => {
                Body::Equal(sides.iter().take(if found.entry == 0 { sides.len() } else { 1 }).map(items).collect())
            }
            body => body.clone(),
        };
        Statement { parameters: found.parameters.clone(), body, ..statement.clone() }
    };
    all.found.sort_by_key(|found| found.entry != 0);
    Some(all.found.iter().map(statement).collect())
}

/// Replaces the k-th item of cases by cases of k-th items.
fn items(e: &Expr) -> Expr {
    e.replaced(&|e| match &e.kind {
        Kind::Item(tuple, k) => item(tuple, *k),
        _ => None,
    })
}

fn item(tuple: &Expr, k: usize) -> Option<Expr> {
    match &tuple.kind {
        Kind::Tuple(items) => items.get(k).cloned(),
        Kind::Cases(rows) => {
            let row = |(value, condition): &(Expr, Condition)| Some((item(value, k)?, condition.clone()));
            let rows = rows.iter().map(row).collect::<Option<Vec<_>>>()?;
            Some(Expr { kind: Kind::Cases(rows), at: tuple.at })
        }
        _ => None,
    }
}

/// A statement that is used.
struct Found {
    entry: usize,
    place: usize,
    parameters: Vec<Name>,
}

/// Collects statements. A path is where a symbol is looked up: its last entry, then the entries that refer to it.
struct Flat<'e> {
    entries: &'e Entries,
    found: Vec<Found>,
}

impl Flat<'_> {
    fn add(&mut self, path: &[usize], place: usize, given: Vec<Name>) -> Option<()> {
        let entry = *path.last()?;
        let statement = &self.entries.0[entry].statements[place];
        let same = |found: &Found| self.entries.0[found.entry].statements[found.place].names[0] == statement.names[0];
        if let Some(known) = self.found.iter_mut().find(|found| same(found)) {
            if known.parameters.is_empty() {
                known.parameters = given;
            }
            let other = &self.entries.0[known.entry].statements[known.place];
            return (latex::statement(other) == latex::statement(statement)).then_some(());
        }
        let parameters = if statement.parameters.is_empty() { given } else { statement.parameters.clone() };
        self.found.push(Found { entry, place, parameters: parameters.clone() });
        let mut names = Vec::new();
        // For other entries the first form is sufficient.
        let sides = if entry == 0 { usize::MAX } else { 1 };
        let is_chain = matches!(statement.body, Body::ArgMin(_));
        let needed = statement.expressions().into_iter().take(if is_chain { usize::MAX } else { sides });
        needed.for_each(|e| symbols(e, &mut names));
        for name in names.iter().filter(|name| !parameters.contains(name)) {
            self.resolve(path, name)?;
        }
        Some(())
    }

    /// Adds the definition of a symbol, if it has one.
    fn resolve(&mut self, path: &[usize], name: &Name) -> Option<()> {
        let Some((&entry, referring)) = path.split_last() else { return Some(()) };
        let here = &self.entries.0[entry];
        if let Some(place) = here.statements.iter().position(|statement| statement.names[0] == *name) {
            return self.add(path, place, Vec::new());
        }
        let Some(taken) = here.given.iter().find(|taken| taken.name == *name) else {
            return self.resolve(referring, name);
        };
        let there = [path, &[taken.from]].concat();
        match self.entries.0[taken.from].statements.iter().position(|statement| statement.names[0] == *name) {
            Some(place) => self.add(&there, place, taken.parameters.clone()),
            None => self.resolve(&there, name),
        }
    }
}

/// The symbols that an expression refers to, including vectors whose components are written, and symbols that select a
/// component.
pub(super) fn symbols(e: &Expr, names: &mut Vec<Name>) {
    match &e.kind {
        Kind::Symbol(name) => {
            names.push(name.clone());
            if let Some((vector, index)) = name.component() {
                names.push(vector);
                if index.parse::<usize>().is_err() {
                    names.push(Name::letter(index));
                }
            }
        }
        Kind::Apply(name, _) => names.push(name.clone()),
        Kind::Sum { index, from, to, body } => {
            return (*from..=*to).for_each(|k| symbols(&body.with_index(index, k), names));
        }
        _ => {}
    }
    e.parts().into_iter().for_each(|part| symbols(part, names));
}

/// Substitutes every symbol that is used once, except outputs.
pub(super) fn put_in(mut statements: Vec<Statement>, is_output: impl Fn(&Name) -> bool) -> Vec<Statement> {
    while let Some(k) = (0..statements.len()).find(|&k| is_used_once(&statements, k, &is_output)) {
        let definition = statements.remove(k);
        let Body::Equal(sides) = &definition.body else { continue };
        let put = |e: &Expr| match &e.kind {
            Kind::Symbol(name) if *name == definition.names[0] => Some(sides[0].clone()),
            _ => None,
        };
        for statement in &mut statements {
            statement.body = match &statement.body {
                Body::Equal(sides) => Body::Equal(sides.iter().map(|e| e.replaced(&put)).collect()),
                body => body.clone(),
            };
        }
    }
    statements
}

fn is_used_once(statements: &[Statement], k: usize, is_output: impl Fn(&Name) -> bool) -> bool {
    let Statement { names, parameters, body, .. } = &statements[k];
    let name = &names[0];
    let is_plain = parameters.is_empty() && matches!(body, Body::Equal(sides) if sides.len() == 1);
    if !is_plain || is_output(name) {
        return false;
    }
    let mut uses = Vec::new();
    let mut whole = 0;
    for statement in statements {
        let can_hold = matches!(statement.body, Body::Equal(_));
        for e in statement.expressions() {
            symbols(e, &mut uses);
            whole += if can_hold { count(e, name) } else { 0 };
        }
    }
    whole == 1 && uses.iter().filter(|used| *used == name).count() == 1
}

/// The number of occurrences of a symbol in an expression.
fn count(e: &Expr, name: &Name) -> usize {
    let here = matches!(&e.kind, Kind::Symbol(symbol) if symbol == name);
    usize::from(here) + e.parts().into_iter().map(|part| count(part, name)).sum::<usize>()
}

#[cfg(test)]
mod tests {
    use super::put_in;
    use crate::toolkit::equation::latex;
    use crate::toolkit::equation::statement::statements;

    #[test]
    fn what_is_used_once_is_put_in_unless_it_is_an_output() {
        let given = statements(r"a = b + c,\quad d = 2\,a,\quad e = d^2 + d,\quad h = 3\,e", Vec::new()).unwrap();
        let closed = |outputs: &[&str]| -> Vec<String> {
            let is_output = |name: &super::Name| outputs.iter().any(|output| *name == super::Name::letter(*output));
            put_in(given.clone(), is_output).iter().map(latex::statement).collect()
        };
        assert_eq!(closed(&["h"]), [r"d = 2\,(b + c)", r"h = 3\,(d^2 + d)"]);
        assert_eq!(closed(&["e", "h"]), [r"d = 2\,(b + c)", "e = d^2 + d", r"h = 3\,e"]);
    }
}
