//! How well other programs agree with the connectors, as the comparisons with them have recorded it in `tests/data/foreign`.

use anyhow::{Context, ensure};
use kit::{Project, Table};
use serde::Deserialize;

/// The programs in the order of the columns, as their files are called.
const PROGRAMS: [&str; 4] = ["pinocchio", "mujoco", "exudyn", "calculix"];

/// What was compared with a program.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Record {
    program: String,
    version: String,
    comparisons: Vec<Comparison>,
}

/// A quantity of a connector, and the worst error of it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Comparison {
    connector: String,
    quantity: String,
    /// At how many poses, or over how many steps.
    places: String,
    worst: f64,
}

impl Comparison {
    /// What a row of the table is about.
    fn about(&self) -> [&str; 3] {
        [&self.connector, &self.quantity, &self.places]
    }
}

/// The table `agreement`: connectors and what is compared of them, and a column for each program.
pub(crate) fn tables(project: &Project) -> anyhow::Result<Vec<(String, Vec<Table>)>> {
    let folder = project.root().join("tests/data/foreign");
    let record = |program: &&str| {
        let path = folder.join(program).with_extension("json");
        let text = std::fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
        parse(&text).with_context(|| path.display().to_string())
    };
    let records = PROGRAMS.iter().map(record).collect::<anyhow::Result<Vec<_>>>()?;
    Ok(vec![("agreement".to_owned(), vec![table(&records)])])
}

fn parse(text: &str) -> anyhow::Result<Record> {
    let record: Record = serde_json::from_str(text)?;
    for Comparison { connector, quantity, worst, .. } in &record.comparisons {
        ensure!(worst.is_finite() && *worst >= 0.0, "{connector}, {quantity}: {worst} is no error");
    }
    Ok(record)
}

fn table(records: &[Record]) -> Table {
    let all = || records.iter().flat_map(|record| &record.comparisons);
    let mut connectors: Vec<&str> = Vec::new();
    let mut abouts: Vec<[&str; 3]> = Vec::new();
    for comparison in all() {
        if !connectors.contains(&&*comparison.connector) {
            connectors.push(&comparison.connector);
        }
        if !abouts.contains(&comparison.about()) {
            abouts.push(comparison.about());
        }
    }
    // The sort is stable: within a connector, quantities stand as they were first met.
    abouts.sort_by_key(|[connector, ..]| connectors.iter().position(|known| known == connector));
    let cell = |record: &Record, about: &[&str; 3]| {
        let found = record.comparisons.iter().find(|comparison| comparison.about() == *about);
        found.map_or_else(String::new, |comparison| scientific(comparison.worst))
    };
    let row = |about: &[&str; 3]| {
        let texts = about.iter().map(|text| (*text).to_owned());
        texts.chain(records.iter().map(|record| cell(record, about))).collect()
    };
    let programs = records.iter().map(|Record { program, version, .. }| format!("{program} {version}"));
    let head = ["Connector", "Compared", "At"].map(String::from).into_iter().chain(programs).collect();
    Table { head, rows: abouts.iter().map(row).collect(), ..Table::default() }
}

/// In mathematics, with two digits.
fn scientific(error: f64) -> String {
    if error == 0.0 {
        return "0".into();
    }
    let text = format!("{error:.1e}");
    let (mantissa, exponent) = text.split_once('e').expect("the format has an exponent");
    format!("${mantissa}\\cdot 10^{{{exponent}}}$")
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
        let Table { head, rows, .. } = table(&[record("One", one).unwrap(), record("Two", two).unwrap()]);
        assert_eq!(head, ["Connector", "Compared", "At", "One 1.0", "Two 1.0"]);
        assert_eq!(rows[0], ["JOIN", "rows", "9 poses", r"$2.5\cdot 10^{-16}$", ""]);
        assert_eq!(rows[1], ["JOIN", "forces", "9 poses", "", r"$1.0\cdot 10^{-9}$"]);
        assert_eq!(rows[2], ["SLOT", "rows", "9 poses", "0", ""]);
    }

    #[test]
    fn what_is_no_error_is_refused() {
        let wrong = |worst: &str| {
            record("One", &format!(r#"{{"connector": "J", "quantity": "rows", "places": "1", "worst": {worst}}}"#))
        };
        assert!(wrong("1e-9").is_ok() && wrong("-1e-9").is_err() && wrong("null").is_err());
    }
}
