//! Calculators: the entry of a formula evaluates it with the exported JavaScript.
//!
//! A page loads one script; that of a formula is loaded when its calculator is opened. Everything is a classic script,
//! so that it works from `file://`.

mod check;
mod sizes;
#[cfg(test)]
mod tests;

pub(crate) use check::{check, pages as chapters};

use jointproof::catalog::{AnyFormula, KinkEntry};
use jointproof::formula::proof::Flag;
use jointproof::toolkit::verify::golden::{File, Record, components};

use super::content::{Calculator, Entry};
use super::html::{each, escape};
use crate::export;

/// The folder in the book.
const FOLDER: &str = "calculator";

/// The beginning of an entry's calculator; pages without it need no script.
const MARK: &str = "<details class=\"calculator\"";

/// The script of a page, which opens calculators.
const START: &str = include_str!("start.js");

/// The scripts loaded when the first calculator is opened, in order.
const PARTS: [&str; 4] =
    [include_str!("numbers.js"), include_str!("plot.js"), include_str!("copy.js"), include_str!("panel.js")];

/// The number of random cases in the menu.
const RANDOM: usize = 1;

/// The text before the cases in the script of a formula.
const CASES: &str = "cases:";

const STYLE: &str = include_str!("calculator.css");

/// The calculator of a formula.
pub(crate) fn of(formula: &'static dyn AnyFormula, golden: Option<&File>) -> Calculator {
    let script = match export::script(formula) {
        Ok(script) => script,
        Err(why) => return Calculator::Refused(why.to_string()),
    };
    let cases = golden.map_or(String::new(), |golden| cases(formula, golden));
    let kinks = each(formula.kinks(), |kink| kink_line(&kink));
    let id = formula.spec().id;
    Calculator::Script(format!(
        "'use strict';\njointproof.define('{id}', {}, {{\n{CASES} [\n{cases}],\nkinks: [\n{kinks}],\n}});\n",
        script.text()
    ))
}

/// One line per golden case: identifier, flag, comment, and the components that differ from the previous case.
fn cases(formula: &dyn AnyFormula, golden: &File) -> String {
    let (mut before, mut random): (Vec<f64>, _) = (Vec::new(), 0);
    let line = |case: &Record| {
        random += usize::from(case.flags.contains(&Flag::Random));
        if case.flags.contains(&Flag::Random) && random > RANDOM {
            return String::new();
        }
        let Ok(inputs) = components(formula.inputs(), &case.inputs) else { return String::new() };
        let differs = |k: usize, x: f64| before.get(k).is_none_or(|old| old.to_bits() != x.to_bits());
        let changed = inputs.iter().enumerate().filter(|&(k, &x)| differs(k, x));
        let changed: Vec<_> = changed.map(|(k, &x)| format!("{k}: {}", number(x))).collect();
        before.clone_from(&inputs);
        let flag = case.flags.last().map_or("", |flag| flag.name());
        let words = [case.id.as_str(), flag, &case.comment].map(|word| serde_json::Value::from(word).to_string());
        format!("[{}, {{ {} }}],\n", words.join(", "), changed.join(", "))
    };
    each(&golden.cases, line)
}

/// A line for a kink: a point on it, a direction across it, and the derivatives of every output on both sides.
fn kink_line(kink: &KinkEntry) -> String {
    let list = |numbers: &[f64]| numbers.iter().map(|&x| number(x)).collect::<Vec<_>>().join(", ");
    let sides: Vec<_> = kink.one_sided.iter().map(|sides| format!("[{}]", list(sides))).collect();
    format!("{{ at: [{}], across: [{}], sides: [{}] }},\n", list(&kink.at), list(&kink.across), sides.join(", "))
}

/// A number in JavaScript.
fn number(x: f64) -> String {
    match x {
        x if x.is_nan() => "NaN".into(),
        x if x.is_infinite() => if x > 0.0 { "Infinity" } else { "-Infinity" }.into(),
        x => serde_json::Value::from(x).to_string().trim_end_matches(".0").into(),
    }
}

/// The folded calculator of an entry, or why it has none.
pub(crate) fn folded(entry: &Entry) -> String {
    match &entry.calculator {
        Calculator::Absent => String::new(),
        Calculator::Refused(why) => {
            format!("<p class=\"refused\">Not exported, hence no calculator: {}.</p>", escape(why))
        }
        Calculator::Script(_) => {
            format!("{MARK} data-formula=\"{}\"><summary>Calculator</summary></details>", escape(&entry.id))
        }
    }
}

/// The additions to the head of a page with calculators; empty for other pages. `to_root` is the path to the root of the book.
pub(crate) fn head(page: &str, to_root: &str) -> String {
    if !page.contains(MARK) {
        return String::new();
    }
    let folder = format!("{to_root}{FOLDER}");
    format!(
        "<link rel=\"stylesheet\" href=\"{folder}/calculator.css\">\n\
         <script defer src=\"{folder}/calculator.js\"></script>\n"
    )
}

/// A script or a style sheet without comments and indentation; none of its strings spans several lines.
fn short(text: &str) -> String {
    let lines = text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with("//") && !line.starts_with("/*"));
    each(lines, |line| format!("{line}\n"))
}

/// The scripts and the style sheet with their paths in the book, if there are any calculators.
pub(crate) fn files(entries: &[Entry]) -> Vec<(String, String)> {
    let script = |entry: &Entry| match &entry.calculator {
        Calculator::Script(text) => Some((format!("{FOLDER}/{}.js", entry.id), short(text))),
        _ => None,
    };
    let mut files: Vec<_> = entries.iter().filter_map(script).collect();
    if files.is_empty() {
        return files;
    }
    let runtime = format!("'use strict';\njointproof.define('runtime', {});\n", export::runtime_script());
    let panel =
        format!("'use strict';\njointproof.define('panel', () => {{\n{}\nreturn Panel;\n}});\n", PARTS.concat());
    let start = format!("(() => {{\n'use strict';\n{START}}})();\n");
    for (name, text) in [("runtime", runtime), ("panel", panel), ("calculator", start)] {
        files.push((format!("{FOLDER}/{name}.js"), short(&text)));
    }
    files.push((format!("{FOLDER}/calculator.css"), short(STYLE)));
    files
}
