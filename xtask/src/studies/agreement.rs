//! The agreement of other programs with the connectors, as recorded by the comparisons in `tests/data/foreign`.

use anyhow::{Context, ensure};
use kit::{Project, Table};
use serde::Deserialize;

/// The programs in the order of the columns, with the names of their files.
const PROGRAMS: [&str; 4] = ["pinocchio", "mujoco", "exudyn", "calculix"];

/// The comparisons with a program.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Record {
    program: String,
    version: String,
    comparisons: Vec<Comparison>,
}

/// A quantity of a connector, and its largest error.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Comparison {
    connector: String,
    quantity: String,
    /// The number of poses or steps.
    places: String,
    worst: f64,
}

/// The table `agreement`, connectors by programs, and `agreement-of-quantities`, the quantities compared by programs.
pub(crate) fn tables(project: &Project) -> anyhow::Result<Vec<(String, Vec<Table>)>> {
    let folder = project.root().join("tests/data/foreign");
    let record = |program: &&str| {
        let path = folder.join(program).with_extension("json");
        let text = std::fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
        parse(&text).with_context(|| path.display().to_string())
    };
    let records = PROGRAMS.iter().map(record).collect::<anyhow::Result<Vec<_>>>()?;
    let tables = [("agreement", by_connector(&records)), ("agreement-of-quantities", by_quantity(&records))];
    Ok(tables.map(|(name, table)| (name.to_owned(), vec![table])).into())
}

fn parse(text: &str) -> anyhow::Result<Record> {
    let record: Record = serde_json::from_str(text)?;
    for Comparison { connector, quantity, worst, .. } in &record.comparisons {
        ensure!(worst.is_finite() && *worst >= 0.0, "{connector}, {quantity}: {worst} is no error");
    }
    Ok(record)
}

/// The largest error of each connector.
fn by_connector(records: &[Record]) -> Table {
    rows(records, ["Connector"], |comparison| [comparison.connector.clone()])
}

/// The largest error of each quantity, grouped by connector.
fn by_quantity(records: &[Record]) -> Table {
    rows(records, ["Connector", "Compared"], |Comparison { connector, quantity, places, .. }| {
        [connector.clone(), format!("{quantity}, {places}")]
    })
}

/// One row for all comparisons of the same quantity, and one column for each program.
fn rows<const N: usize>(records: &[Record], head: [&str; N], about: impl Fn(&Comparison) -> [String; N]) -> Table {
    let mut abouts: Vec<[String; N]> = Vec::new();
    for comparison in records.iter().flat_map(|record| &record.comparisons) {
        if !abouts.contains(&about(comparison)) {
            abouts.push(about(comparison));
        }
    }
    // Connectors, and quantities of each, in the order of first occurrence.
    let connectors: Vec<String> = abouts.iter().map(|about| about[0].clone()).collect();
    abouts.sort_by_key(|about| connectors.iter().position(|connector| *connector == about[0]));
    let cell = |record: &Record, of: &[String; N]| {
        let errors = record.comparisons.iter().filter(|comparison| about(comparison) == *of).map(|found| found.worst);
        errors.reduce(f64::max).map_or_else(String::new, scientific)
    };
    let row = |of: &[String; N]| of.iter().cloned().chain(records.iter().map(|record| cell(record, of))).collect();
    let programs = records.iter().map(|Record { program, version, .. }| format!("{program} {version}"));
    let head = head.iter().map(|text| (*text).to_owned()).chain(programs).collect();
    Table { head, rows: abouts.iter().map(row).collect(), ..Table::default() }
}

/// In scientific notation, with two digits.
fn scientific(error: f64) -> String {
    if error == 0.0 {
        return "0".into();
    }
    let text = format!("{error:.1e}");
    let (mantissa, exponent) = text.split_once('e').expect("the format has an exponent");
    format!("${mantissa}\\cdot10^{{{exponent}}}$")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(program: &str, comparisons: &str) -> anyhow::Result<Record> {
        parse(&format!(r#"{{"program": "{program}", "version": "1.0", "comparisons": [{comparisons}]}}"#))
    }

    #[test]
    fn each_quantity_has_a_row_beside_those_of_its_connector_and_each_program_a_column() {
        let one = r#"{"connector": "JOIN", "quantity": "rows", "places": "9 poses", "worst": 2.5e-16},
            {"connector": "SLOT", "quantity": "rows", "places": "9 poses", "worst": 0}"#;
        let two = r#"{"connector": "JOIN", "quantity": "forces", "places": "9 poses", "worst": 1e-9}"#;
        let records = [record("One", one).unwrap(), record("Two", two).unwrap()];
        let Table { head, rows, .. } = by_quantity(&records);
        assert_eq!(head, ["Connector", "Compared", "One 1.0", "Two 1.0"]);
        assert_eq!(rows[0], ["JOIN", "rows, 9 poses", r"$2.5\cdot10^{-16}$", ""]);
        assert_eq!(rows[1], ["JOIN", "forces, 9 poses", "", r"$1.0\cdot10^{-9}$"]);
        assert_eq!(rows[2], ["SLOT", "rows, 9 poses", "0", ""]);
        let Table { head, rows, .. } = by_connector(&records);
        assert_eq!(head, ["Connector", "One 1.0", "Two 1.0"]);
        assert_eq!(rows, [["JOIN", r"$2.5\cdot10^{-16}$", r"$1.0\cdot10^{-9}$"], ["SLOT", "0", ""]]);
    }

    #[test]
    fn what_is_no_error_is_refused() {
        let wrong = |worst: &str| {
            record("One", &format!(r#"{{"connector": "J", "quantity": "rows", "places": "1", "worst": {worst}}}"#))
        };
        assert!(wrong("1e-9").is_ok() && wrong("-1e-9").is_err() && wrong("null").is_err());
    }
}
