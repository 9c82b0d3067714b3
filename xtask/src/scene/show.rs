//! Results and plans as text, JSON and CSV.

use crate::console::{bold, progress};
use jointproof::scene::{Kind, Plan, Results, Run, Scene, Series, Warning};
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

/// The number of elements shown in a table on the terminal.
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
    // A torque is not available in every state.
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

/// Nine significant digits, without trailing zeros.
pub(super) fn digits(x: f64) -> String {
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

/// The meaning of an output for the elements shown, with its unit; several if it differs between kinds.
fn meaning(scene: &Scene, results: &Results, output: &str) -> String {
    let of_output = results.series.iter().filter(|series| series.output == output);
    // The torque of a slide line is listed under the name of the line, but is an output of its elements.
    let sliding = || Kind::all().find(|kind| kind.slides() && kind.output(output).is_some());
    let mut meanings: Vec<(&str, String)> = Vec::new();
    // Of many consecutive elements of one kind, only one is looked up.
    let mut kinds: Vec<&Kind> = of_output.filter_map(|series| scene.kind(&series.element).or_else(sliding)).collect();
    kinds.dedup_by_key(|kind| kind.name);
    for kind in kinds {
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

/// Evaluates and writes state by state, so that memory does not grow with the number of states. If a formula turns out
/// to be undefined, what was written before is valid, and the exit code indicates that the output is incomplete.
pub(crate) fn stream(plan: &Plan<'_>, out: &mut impl Write) -> anyhow::Result<Vec<Warning>> {
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
    out.flush()?;
    Ok(run.warnings().to_vec())
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

    /// The given number of slots whose second nodes move by a quarter and by a half.
    fn scene(elements: usize, outputs: &str) -> Scene {
        let elements: Vec<_> =
            (0..elements).map(|k| format!(r#""e{k}": {{"kind": "slot", "nodes": ["a", "b"]}}"#)).collect();
        let text = format!(
            r#"{{"title": "Slots", "dimension": "2d", "orientations": {{"o": {{"angle": 0}}}},
            "nodes": {{"a": {{"at": [0, 0], "orientation": "o"}}, "b": {{"at": [1, 0]}}}},
            "elements": {{{}}}, "outputs": {outputs}, "frames": [{{"time": 0, "nodes": {{"b": {{"u": [0.25, 0]}}}}}},
            {{"time": 12.5, "nodes": {{"b": {{"u": [0.5, 0]}}}}, "loads": {{"e0": {{"f2": 3}}}}}}]}}"#,
            elements.join(", ")
        );
        Scene::parse(&text).unwrap()
    }

    /// Results, and a copy with the last number increased by a quarter.
    fn both(scene: &Scene) -> [Results; 2] {
        let found = Results::of(scene).unwrap();
        let mut other = found.clone();
        *other.series.last_mut().unwrap().values.numbers_mut().last_mut().unwrap() += 0.25;
        [found, other]
    }

    /// The tables of a text.
    fn tables(text: &str) -> Vec<&str> {
        text.lines().filter(|line| line.starts_with("  ") && !line.contains('×')).collect()
    }

    #[test]
    fn a_table_has_a_column_per_element_and_one_per_error() {
        let scene = scene(2, r#"["U1"]"#);
        let [found, other] = both(&scene);
        let shown = results(&scene, &found, None, Format::Text).unwrap();
        assert_eq!(tables(&shown), ["  time    e0    e1", "   0.0  0.25  0.25", "  12.5   0.5   0.5"]);
        assert!(shown.contains("Slots") && !shown.contains("more elements"));
        assert!(shown.contains("        4 × slot.relative_motion\n"), "{shown}");
        let shown = results(&scene, &found, Some(&other), Format::Text).unwrap();
        let expected = [
            "  time    e0  error    e1    error",
            "   0.0  0.25      0  0.25        0",
            "  12.5   0.5      0   0.5  -2.5e-1",
        ];
        assert_eq!(tables(&shown), expected);
        let vector = self::scene(1, r#"["RF", "U1"]"#);
        let shown = results(&vector, &Results::of(&vector).unwrap(), None, Format::Text).unwrap();
        let expected = [
            "  time    e0",
            "   0.0  0.25",
            "  12.5   0.5",
            "  time  e0[0]  e0[1]  e0[2]",
            "   0.0      0      0      0",
            "  12.5      0      3      0",
        ];
        assert_eq!(tables(&shown), expected);
    }

    #[test]
    fn elements_that_are_not_shown_are_counted() {
        for (elements, rest) in [(8, None), (9, Some("… and 1 more elements")), (11, Some("… and 3 more elements"))]
        {
            let scene = scene(elements, r#"["U1"]"#);
            let shown = results(&scene, &Results::of(&scene).unwrap(), None, Format::Text).unwrap();
            let said = shown.lines().find(|line| line.starts_with('…'));
            assert_eq!(said, rest.map(|rest| format!("{rest}: --format csv or json prints all")).as_deref());
        }
    }

    #[test]
    fn a_line_of_csv_has_a_number_and_its_error() {
        let scene = scene(2, r#"["U1"]"#);
        let [found, other] = both(&scene);
        let lines = "0.0,e0,U1,0,0.25\n0.0,e1,U1,0,0.25\n12.5,e0,U1,0,0.5\n12.5,e1,U1,0,0.5\n";
        let shown = results(&scene, &found, None, Format::Csv).unwrap();
        assert_eq!(shown, format!("{HEAD}{lines}"));
        let mut streamed = Vec::new();
        stream(&Plan::new(&scene), &mut streamed).unwrap();
        assert_eq!(String::from_utf8(streamed).unwrap(), shown);
        let expected = "time,element,output,component,value,error\n0.0,e0,U1,0,0.25,0.0\n0.0,e1,U1,0,0.25,0.0\n\
            12.5,e0,U1,0,0.5,0.0\n12.5,e1,U1,0,0.5,-0.25\n";
        assert_eq!(results(&scene, &found, Some(&other), Format::Csv).unwrap(), expected);
    }

    #[test]
    fn json_has_an_error_for_every_number() {
        let scene = scene(2, r#"["U1"]"#);
        let [found, other] = both(&scene);
        let of = |exact| -> serde_json::Value {
            serde_json::from_str(&results(&scene, &found, exact, Format::Json).unwrap()).unwrap()
        };
        assert!(of(None)["series"][0].get("errors").is_none());
        let errors = of(Some(&other));
        assert_eq!(errors["series"][0]["errors"], json!([[0.0], [0.0]]));
        assert_eq!(errors["series"][1]["errors"], json!([[0.0], [-0.25]]));
    }

    #[test]
    fn a_plan_says_how_often_each_formula_is_evaluated_for_an_element() {
        let scene = scene(3, r#"["U1"]"#);
        let scenes_plan = Plan::new(&scene);
        let shown = |format| plan(&scenes_plan, format).unwrap();
        let csv = shown(Format::Csv);
        let times: Vec<_> = csv.lines().map(|line| line.split(',').take(4).collect::<Vec<_>>().join(",")).collect();
        let expected = [
            "formula,kind,elements,times",
            "slot.relative_position,slot,3,1",
            "slot.relative_position,slot,3,2",
            "slot.relative_motion,slot,3,2",
        ];
        assert_eq!(times, expected);
        let json: Vec<serde_json::Value> = serde_json::from_str(&shown(Format::Json)).unwrap();
        assert_eq!(json.iter().map(|line| line["times"].as_u64().unwrap()).collect::<Vec<_>>(), [1, 2, 2]);
        assert!(shown(Format::Text).ends_with("\n15 evaluations over 2 states\n"));
    }
}
