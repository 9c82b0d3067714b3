//! Results and plans as text, JSON and CSV.

use crate::console::{bold, progress};
use jointproof::scene::{Kind, Plan, Results, Run, Scene, Series};
use serde_json::json;
use std::fmt::Write as _;
use std::io::{BufWriter, Write};

/// How results are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Format {
    /// A table per output.
    Text,
    /// One object: times, how often each formula ran, and a series per element and output; of several scenes, an array.
    Json,
    /// A line per number.
    Csv,
}

/// Elements that a table on the terminal has.
pub(crate) const SHOWN: usize = 8;

pub(crate) fn plan(plan: &Plan<'_>, format: Format) -> anyhow::Result<String> {
    let lines = plan.lines();
    let states = plan.scene().times().len();
    if format == Format::Text {
        let mut text = String::new();
        for line in &lines {
            writeln!(text, "{line}")?;
        }
        let total: usize = plan.counts(states).iter().map(|(_, count)| count).sum();
        writeln!(text, "{total} evaluations over {states} states")?;
        return Ok(text);
    }
    if format == Format::Csv {
        let mut text = String::from("formula,kind,elements,times,why\n");
        for line in &lines {
            let times = if line.once { 1 } else { states };
            writeln!(text, "{},{},{},{times},{}", line.formula, line.kind, line.elements, quoted(&line.why))?;
        }
        return Ok(text);
    }
    let lines: Vec<_> = lines
        .iter()
        .map(|line| {
            let times = if line.once { 1 } else { states };
            json!({ "formula": line.formula, "kind": line.kind, "elements": line.elements, "times": times, "why": line.why })
        })
        .collect();
    Ok(serde_json::to_string_pretty(&lines)?)
}

pub(crate) fn results(
    scene: &Scene,
    results: &Results,
    exact: Option<&Results>,
    format: Format,
) -> anyhow::Result<String> {
    match format {
        Format::Text => text(scene, results, exact),
        Format::Csv => csv(results, exact),
        Format::Json => {
            let Some(exact) = exact else { return Ok(serde_json::to_string_pretty(results)?) };
            let mut value = serde_json::to_value(results)?;
            for (k, (series, exact)) in results.series.iter().zip(&exact.series).enumerate() {
                value["series"][k]["errors"] = json!(errors(series, exact));
            }
            Ok(serde_json::to_string_pretty(&value)?)
        }
    }
}

/// f64 minus exact, number by number.
fn errors(series: &Series, exact: &Series) -> Vec<Vec<f64>> {
    let state = |(values, exact): (&[f64], &[f64])| values.iter().zip(exact).map(|(a, b)| a - b).collect();
    series.values.iter().zip(exact.values.iter()).map(state).collect()
}

/// A column of a table: heading, and a number per state.
struct Column {
    heading: String,
    numbers: Vec<String>,
}

fn text(scene: &Scene, results: &Results, exact: Option<&Results>) -> anyhow::Result<String> {
    let mut text = String::new();
    if !results.title.is_empty() {
        writeln!(text, "{}\n", bold(&results.title))?;
    }
    let mut outputs: Vec<&str> = results.series.iter().map(|series| series.output).collect();
    outputs.sort_unstable();
    outputs.dedup();
    let order = |output: &str| results.series.iter().position(|series| series.output == output);
    outputs.sort_by_key(|output| order(output));
    for output in outputs {
        writeln!(text, "{}  {}", bold(output), meaning(scene, results, output))?;
        let times = results.times.iter().map(|time| format!("{time:?}")).collect();
        let mut columns = vec![Column { heading: "time".into(), numbers: times }];
        for (k, series) in results.series.iter().enumerate().filter(|(_, series)| series.output == output) {
            add_columns(&mut columns, series, exact.and_then(|exact| exact.series.get(k)));
        }
        table(&mut text, &columns)?;
        text.push('\n');
    }
    let rest = scene.size().saturating_sub(SHOWN);
    if rest > 0 {
        writeln!(text, "… and {rest} more elements: --format csv or json prints all")?;
    }
    writeln!(text, "{}", bold("formulas evaluated"))?;
    for (formula, count) in &results.counts {
        writeln!(text, "{count:>9} × {formula}")?;
    }
    Ok(text)
}

fn add_columns(columns: &mut Vec<Column>, series: &Series, exact: Option<&Series>) {
    // A torque is not there in every state.
    let width = series.values.width();
    for component in 0..width {
        let heading = match width {
            1 => series.element.clone(),
            _ => format!("{}[{component}]", series.element),
        };
        let numbers = |of: &dyn Fn(usize) -> Option<f64>, digits: &dyn Fn(f64) -> String| {
            (0..series.values.len()).map(|state| of(state).map_or_else(String::new, digits)).collect()
        };
        let at = |series: &Series, state| series.values.get(state)?.get(component).copied();
        let value = |state: usize| at(series, state);
        columns.push(Column { heading, numbers: numbers(&value, &digits) });
        if let Some(exact) = exact {
            let error = |state: usize| Some(value(state)? - at(exact, state)?);
            let numbers = numbers(&error, &|x| if x == 0.0 { "0".into() } else { format!("{x:.1e}") });
            columns.push(Column { heading: "error".into(), numbers });
        }
    }
}

/// Nine significant digits, without zeros that say nothing.
fn digits(x: f64) -> String {
    let magnitude = if x == 0.0 { x } else { x.abs().log10().floor() };
    if !(-5.0..9.0).contains(&magnitude) {
        return format!("{x:.8e}");
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 13")]
    let decimals = (8.0 - magnitude) as usize;
    let text = format!("{x:.decimals$}");
    if decimals == 0 { text } else { text.trim_end_matches('0').trim_end_matches('.').into() }
}

fn table(text: &mut String, columns: &[Column]) -> std::fmt::Result {
    let width = |column: &Column| {
        let cells = column.numbers.iter().map(|number| number.chars().count());
        cells.chain([column.heading.chars().count()]).max().unwrap_or(0)
    };
    let widths: Vec<_> = columns.iter().map(width).collect();
    for (column, width) in columns.iter().zip(&widths) {
        write!(text, "  {:>width$}", column.heading)?;
    }
    text.push('\n');
    for row in 0..columns.first().map_or(0, |column| column.numbers.len()) {
        for (column, width) in columns.iter().zip(&widths) {
            write!(text, "  {:>width$}", column.numbers[row])?;
        }
        text.push('\n');
    }
    Ok(())
}

/// What an output is of the elements that show it, with its unit: one meaning, or one for each kind that means something else.
fn meaning(scene: &Scene, results: &Results, output: &str) -> String {
    let of_output = results.series.iter().filter(|series| series.output == output);
    // The torque of a slide line goes by the name of the line; it is that of its elements.
    let sliding = || Kind::all().find(|kind| kind.slides() && kind.output(output).is_some());
    let mut meanings: Vec<(&str, String)> = Vec::new();
    for kind in of_output.filter_map(|series| scene.kind(&series.element).or_else(sliding)) {
        let Some(quantity) = kind.output(output).and_then(|register| kind.quantity(register)) else { continue };
        let words = format!("{} ({})", quantity.meaning, quantity.unit);
        if meanings.iter().all(|(_, known)| *known != words) {
            meanings.push((kind.name, words));
        }
    }
    match &*meanings {
        [(_, one)] => one.clone(),
        several => several.iter().map(|(kind, words)| format!("{kind}: {words}")).collect::<Vec<_>>().join("; "),
    }
}

/// A CSV field.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) { format!("\"{}\"", field.replace('"', "\"\"")) } else { field.into() }
}

fn csv(results: &Results, exact: Option<&Results>) -> anyhow::Result<String> {
    let mut text = String::from(if exact.is_some() { "time,element,output,component,value,error\n" } else { HEAD });
    for (state, time) in results.times.iter().enumerate() {
        for (k, series) in results.series.iter().enumerate() {
            for (component, value) in series.values.get(state).unwrap_or_default().iter().enumerate() {
                write!(text, "{time:?},{},{},{component},{value:?}", quoted(&series.element), series.output)?;
                let exact = exact.and_then(|exact| exact.series.get(k)?.values.get(state)?.get(component));
                if let Some(exact) = exact {
                    write!(text, ",{:?}", value - exact)?;
                }
                text.push('\n');
            }
        }
    }
    Ok(text)
}

const HEAD: &str = "time,element,output,component,value\n";

/// Evaluates and writes state by state, so that memory does not grow with the number of states. What was written before
/// a formula turns out to be undefined is right, and the exit code says that there was no more.
pub(crate) fn stream(plan: &Plan<'_>, out: &mut impl Write) -> anyhow::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 20, out);
    let scene = plan.scene();
    let mut run = Run::<f64>::new(plan)?;
    let bar = progress("scene", scene.times().len());
    out.write_all(HEAD.as_bytes())?;
    for time in scene.times() {
        run.advance()?;
        let mut written = Ok(());
        run.for_each_result(usize::MAX, |element, output, components| {
            for (component, value) in components.iter().enumerate() {
                if written.is_ok() {
                    written = writeln!(out, "{time:?},{},{output},{component},{value:?}", quoted(element));
                }
            }
        });
        written?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(out.flush()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_nine_digits_and_no_more() {
        for (number, shown) in [
            (0.0, "0"),
            (1.0, "1"),
            (-0.25, "-0.25"),
            (1.0 / 3.0, "0.333333333"),
            (1e-5, "0.00001"),
            (9e-6, "9.00000000e-6"),
            (123_456_789.5, "123456790"),
            (1e9, "1.00000000e9"),
            (-1e-200, "-1.00000000e-200"),
        ] {
            assert_eq!(digits(number), shown);
        }
    }

    #[test]
    fn a_comma_in_a_name_is_quoted() {
        assert_eq!(quoted(r#"a "b", c"#), r#""a ""b"", c""#);
    }
}
