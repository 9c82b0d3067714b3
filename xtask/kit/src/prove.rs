//! `prove`: certificates of bounds of rounding errors, written or checked.

use crate::console::{bold, count, green, print, progress, red, say};
use crate::files;
use crate::outcome::{Outcome, verdict};
use crate::project::Project;
use crate::selection::{Formulas, Selection};
use indicatif::ParallelProgressIterator;
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::toolkit::bound::{self, Head, Programme, Proof, Summary};
use jointproof::toolkit::graph::Graph;
use jointproof::toolkit::verify::Audit;
use microlp::{ComparisonOp, OptimizationDirection, Problem, SolveOutcome, Variable};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::fmt::Write;
use std::path::PathBuf;

/// Prove bounds of the rounding errors of values and Jacobians, or check the proofs
///
/// A bound is proved by a certificate: how often each of a few rules is used, which add up to the bound. It holds for all inputs.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} prove                       write changed certificates, remove those without a formula
  {command} prove --check               check the committed certificates, write nothing
  {command} prove --filter '{family}.*' only the formulas of a family
  {command} prove --graphs graphs       write the graphs that the certificates are about into a folder")]
pub(crate) struct Arguments {
    /// Check the committed certificates and write nothing; exit 1 if one does not add up
    #[arg(long)]
    check: bool,
    /// Write into this folder the graphs that the certificates are about, for another checker
    #[arg(long, value_name = "FOLDER", conflicts_with = "check")]
    graphs: Option<PathBuf>,
    #[command(flatten)]
    selection: Selection,
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    let formulas = arguments.selection.formulas(project)?;
    if let Some(folder) = &arguments.graphs {
        for formula in &formulas {
            if let Ok(graph) = formula.graph() {
                files::write(&folder.join(name(*formula)), &graph.text(formula.inputs()))?;
            }
        }
        print(&format!("{} in {}\n", count(formulas.len(), "graph"), folder.display()))?;
        return Ok(verdict(true));
    }
    project.needs_sources("prove")?;
    if arguments.check {
        let Certified { passed, counts, off } = check(project, &arguments.selection)?;
        let mark = if passed { green("ok") } else { red("off") };
        print(&format!("{off}{mark} {counts}\n"))?;
        if !passed {
            say_what_mends(project);
        }
        return Ok(verdict(passed));
    }
    print(&write(project, &arguments.selection, &formulas)?)?;
    Ok(verdict(true))
}

/// Tells how to resolve what is off.
pub(crate) fn say_what_mends(project: &Project) {
    say(&format!("to prove the bounds again: {} prove", project.command()));
}

/// Whether the project keeps certificates.
pub(crate) fn has_certificates(project: &Project) -> bool {
    folder(project).is_dir()
}

fn name(formula: &dyn AnyFormula) -> String {
    format!("{}.jsonl", formula.spec().id)
}

fn folder(project: &Project) -> PathBuf {
    project.golden().join("bounds")
}

fn write(project: &Project, selection: &Selection, formulas: &Formulas) -> anyhow::Result<String> {
    let bar = progress("prove", formulas.len());
    let prove = |formula: &&dyn AnyFormula| {
        let graph = formula.graph().ok()?;
        let proof = proved_of(*formula, &graph);
        Some((
            name(*formula),
            proof.render(&graph, formula.spec().id, &digest(*formula, &graph)),
            Total::of(&proof, &graph),
        ))
    };
    let proved: Vec<_> = formulas.par_iter().progress_with(bar).map(prove).collect();
    let (mut report, mut total) = (String::new(), Total::default());
    for (name, text, of) in proved.into_iter().flatten() {
        let path = folder(project).join(name);
        if files::write(&path, &text)? {
            writeln!(report, "wrote {}", project.shown(&path))?;
        }
        total.add(&of);
    }
    for orphan in if selection.is_all() { orphans(project)? } else { Vec::new() } {
        std::fs::remove_file(&orphan)?;
        writeln!(report, "removed {}: no such formula", project.shown(&orphan))?;
    }
    writeln!(report, "{}", total.text())?;
    Ok(report)
}

/// Certificates of formulas that no longer exist.
fn orphans(project: &Project) -> anyhow::Result<Vec<PathBuf>> {
    files::with_extension_but(&folder(project), "jsonl", |id| project.find(id).is_some())
}

/// The result of a check.
pub(crate) struct Certified {
    pub(crate) passed: bool,
    pub(crate) counts: String,
    /// What is off, a line each.
    pub(crate) off: String,
}

/// Adds up the committed certificates.
pub(crate) fn check(project: &Project, selection: &Selection) -> anyhow::Result<Certified> {
    let formulas = selection.formulas(project)?;
    let bar = progress("bounds", formulas.len());
    let results: Vec<_> = formulas.par_iter().progress_with(bar).map(|formula| examined(project, *formula)).collect();
    let (mut off, mut total) = (String::new(), Total::default());
    for result in results {
        match result {
            Ok(of) => total.add(&of),
            Err(why) => writeln!(off, "{why}")?,
        }
    }
    for orphan in if selection.is_all() { orphans(project)? } else { Vec::new() } {
        writeln!(off, "{} has no formula", bold(project.shown(&orphan)))?;
    }
    Ok(Certified { passed: off.is_empty(), counts: total.text(), off })
}

/// What the committed certificates of a formula prove.
fn examined(project: &Project, formula: &dyn AnyFormula) -> Result<Total, String> {
    let Ok(graph) = formula.graph() else { return Ok(Total::default()) };
    let path = folder(project).join(name(formula));
    let wrong = |why: String| format!("{}: {why}", bold(project.shown(&path)));
    let text = std::fs::read_to_string(&path).map_err(|error| wrong(error.to_string()))?;
    let proof = read(&text, formula, &graph).map_err(wrong)?;
    proof.check(&graph, fields(formula)).map_err(wrong)?;
    Ok(Total::of(&proof, &graph))
}

fn read(text: &str, formula: &dyn AnyFormula, graph: &Graph) -> Result<Proof, String> {
    Proof::parse(text, graph, formula.spec().id, &digest(formula, graph))
}

/// What is said to be proved of value and Jacobian of a formula, as committed; `None` where there is no file about its graph.
pub(crate) fn stated(project: &Project, formula: &dyn AnyFormula) -> Option<[Summary; 2]> {
    let text = std::fs::read_to_string(folder(project).join(name(formula))).ok()?;
    let head = Head::parse(&text).ok()?;
    (head.graph == digest(formula, &formula.graph().ok()?)).then_some([head.value, head.jacobian])
}

/// The bounds of η of a formula in words, proved or measured, with the largest η of an audit.
pub(crate) fn accuracy(project: &Project, formula: &dyn AnyFormula, audit: Option<&Audit>) -> String {
    bound::accuracy(&formula.spec(), stated(project, formula).as_ref(), audit.map_or([None; 2], Audit::largest_eta))
}

/// The same for the formula of an audit, if the project has it.
pub(crate) fn of_audit(project: &Project, audit: &Audit) -> Option<String> {
    project.find(&audit.formula).map(|formula| accuracy(project, formula, Some(audit)))
}

/// Why some entries of value and Jacobian are not proved, a line each.
pub(crate) fn reasons(project: &Project, formula: &dyn AnyFormula) -> Vec<String> {
    let is_closed = formula.spec().is_closed();
    let parts = stated(project, formula).into_iter().flat_map(|both| ["value", "Jacobian"].into_iter().zip(both));
    let open = parts.filter(|(of, summary)| !summary.is_whole() && (*of == "value" || is_closed));
    open.map(|(of, summary)| format!("no proof for the {of}: {}", summary.why)).collect()
}

fn digest(formula: &dyn AnyFormula, graph: &Graph) -> String {
    files::digest(graph.text(formula.inputs()))
}

/// Counts over formulas.
#[derive(Default)]
struct Total {
    formulas: usize,
    whole: usize,
    entries: usize,
    proved: usize,
}

impl Total {
    fn of(proof: &Proof, graph: &Graph) -> Self {
        let both = proof.summaries(graph);
        let [entries, proved] =
            [|of: &Summary| of.entries, |of: &Summary| of.proved].map(|of| both.iter().map(of).sum());
        Self { formulas: 1, whole: usize::from(entries == proved), entries, proved }
    }

    fn add(&mut self, other: &Self) {
        self.formulas += other.formulas;
        self.whole += other.whole;
        self.entries += other.entries;
        self.proved += other.proved;
    }

    fn text(&self) -> String {
        let Self { formulas, whole, entries, proved } = *self;
        format!(
            "{}, {whole} proved whole; {proved} of {}",
            count(formulas, "formula"),
            if entries == 1 { "1 entry".to_owned() } else { format!("{entries} entries") }
        )
    }
}

fn proved_of(formula: &dyn AnyFormula, graph: &Graph) -> Proof {
    Proof::of(graph, fields(formula), solve)
}

fn fields(formula: &dyn AnyFormula) -> [&[Field]; 2] {
    [formula.inputs(), formula.outputs()]
}

/// Solves a linear programme by the simplex method, whose solutions use few rules.
fn solve(programme: &Programme) -> Option<Vec<f64>> {
    // So little that it only decides between solutions of the same bound.
    const USE: f64 = 1e-6;
    let mut problem = Problem::new(OptimizationDirection::Minimize);
    let weights = programme.room.iter().map(|(weight, _)| weight + 1).max().unwrap_or(1);
    let bounds: Vec<Variable> = (0..weights).map(|_| problem.add_var(1.0, (0.0, f64::INFINITY))).collect();
    let amounts: Vec<Variable> = programme.rules.iter().map(|_| problem.add_var(USE, (0.0, f64::INFINITY))).collect();
    let mut parts: Vec<Vec<(Variable, f64)>> =
        programme.room.iter().map(|&(weight, room)| vec![(bounds[weight], -room)]).collect();
    for (adds, &amount) in programme.rules.iter().zip(&amounts) {
        for &(part, factor) in adds {
            parts[part].push((amount, factor));
        }
    }
    for (part, &load) in parts.into_iter().zip(&programme.load) {
        problem.add_constraint(part, ComparisonOp::Le, -load);
    }
    let SolveOutcome::Solution(solution) = problem.solve().ok()? else { return None };
    Some(amounts.into_iter().map(|amount| solution[amount]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog;
    use jointproof::toolkit::bound::{Rational, Rule, check};
    use jointproof::toolkit::graph::{Node, Op};

    fn proved(id: &str) -> (&'static dyn AnyFormula, Graph, Proof) {
        let formula = catalog::find(id).unwrap();
        let graph = formula.graph().unwrap();
        let proof = proved_of(formula, &graph);
        (formula, graph, proof)
    }

    /// Each of these was found by hand, or by another program, to be the least.
    #[test]
    fn bounds_are_the_least_that_the_rules_give() {
        let halves = |halves: i128| Rational::new(halves, 2);
        let known = [
            ("join.nodal_forces", [Some(halves(5)), None]),
            ("slot.contact_force", [Some(halves(2)), Some(halves(6))]),
            ("slot.friction", [Some(Rational::new(5, 3)), Some(halves(6))]),
            ("interaction.damping", [Some(halves(4)), Some(Rational::new(8, 3))]),
            ("slider.eliminate_2d", [Some(halves(5)), Some(Rational::new(7, 3))]),
        ];
        for (id, bounds) in known {
            let (_, graph, proof) = proved(id);
            let found = proof.summaries(&graph).map(|of| (of.entries > 0 && of.is_whole()).then_some(of.bound));
            assert_eq!(found, bounds, "{id}");
        }
    }

    /// Reading gives what was written, and nothing about another graph.
    #[test]
    fn a_file_is_read_as_it_was_written_and_belongs_to_one_graph() {
        let (formula, graph, proof) = proved("slide_line.parabolic_point");
        let text = proof.render(&graph, "slide_line.parabolic_point", &digest(formula, &graph));
        let again = read(&text, formula, &graph).unwrap();
        assert_eq!(
            (
                again.render(&graph, "slide_line.parabolic_point", &digest(formula, &graph)),
                again.check(&graph, fields(formula))
            ),
            (text.clone(), Ok(()))
        );
        let other = catalog::find("slot.friction").unwrap();
        let refused = read(&text, other, &other.graph().unwrap()).unwrap_err();
        assert!(refused.starts_with("line 1: it is about another graph"), "{refused}");
        let half: String = text.lines().take(2).map(|line| line.to_owned() + "\n").collect();
        let refused = read(&half, formula, &graph).unwrap_err();
        assert_eq!(refused, "line 1: the other lines say something else");
        let (&first, _) = proof.results.first_key_value().unwrap();
        let less = Proof { results: proof.results.into_iter().skip(1).collect() };
        let refused = less.check(&graph, fields(formula)).unwrap_err();
        assert_eq!(refused, format!("nothing is said of result {}", first.index()));
    }

    /// Whatever is changed in a certificate is refused, or the bound still holds.
    #[test]
    fn tampered_certificates_are_refused_or_harmless() {
        let (mut refused, mut harmless) = (0, 0);
        for id in [
            "slot.friction",
            "coulomb.return_map_2d",
            "join.nodal_forces",
            "slider.eliminate_2d",
            "slide_line.parabolic_point",
            "universal.constraint_moment",
        ] {
            let (formula, graph, proof) = proved(id);
            let is_input = |node: &Node| matches!(graph.op(*node), Op::Input(_));
            let first = graph.needed(&graph.value).into_iter().find(is_input).unwrap();
            for (&node, certificates) in &proof.results {
                let Ok(certificates) = certificates else { continue };
                let others: Vec<Node> = graph.value.iter().chain(&graph.jacobian).copied().collect();
                let holds = |certificates: &[_]| check(&graph, formula.inputs(), node, &others, certificates);
                assert_eq!(holds(certificates), Ok(()), "{id}");
                assert!(holds(&certificates[1..]).is_err(), "{id}: a way without a certificate");
                for k in 0..certificates.len() {
                    let with = |change: &dyn Fn(&mut jointproof::toolkit::bound::Certificate)| {
                        let mut tampered = certificates.clone();
                        change(&mut tampered[k]);
                        holds(&tampered)
                    };
                    let lower = with(&|of| of.bound -= Rational::new(1, 1000));
                    assert!(lower.is_err(), "{id}: a bound that is lower");
                    let way = with(&|of| of.way.values_mut().for_each(|answer| *answer = !*answer));
                    assert!(way.is_err() || certificates[k].way.is_empty(), "{id}: another way");
                    let by_components = with(&|of| of.beside = None);
                    let is_same = certificates[k].beside.is_none() || certificates[k].steps.is_empty();
                    assert!(by_components.is_err() || is_same, "{id}: no longer normwise");
                    for step in 0..certificates[k].steps.len() {
                        let negative = with(&|of| of.steps[step].1 *= -1);
                        assert!(negative.is_err(), "{id}: a negative amount");
                        let other = with(&|of| of.steps[step].0 = Rule::Parts(first, 0));
                        assert!(other.is_err(), "{id}: a rule that is not there");
                        for verdict in [with(&|of| _ = of.steps.remove(step)), with(&|of| of.steps[step].1 /= 2)] {
                            if verdict.is_err() { refused += 1 } else { harmless += 1 }
                        }
                    }
                }
            }
        }
        assert!(refused > 200 && harmless * 20 < refused, "{refused} refused, {harmless} harmless");
    }
}
