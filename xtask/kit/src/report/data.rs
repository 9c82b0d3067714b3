//! A report: the measurements, with place, time and tools.

use crate::project::Project;
use crate::{evidence, files};
use anyhow::Context;
use jointproof::toolkit::measure::{Measurement, Options};
use measuring::Build;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

/// Everything a run of `report` found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Report {
    /// The layout of this file.
    pub(crate) version: u32,
    /// When it was made, in UTC.
    pub(crate) created: String,
    /// Fingerprint of the sources it is about.
    pub(crate) sources: String,
    /// Where it was made.
    pub(crate) machine: Machine,
    /// With what the measured program was built.
    pub(crate) build: Build,
    /// How much was measured.
    pub(crate) options: Options,
    /// What was found.
    pub(crate) formulas: Vec<Measurement>,
}

/// The layout written by this version.
const VERSION: u32 = 3;

/// A machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Machine {
    /// The processor.
    pub(crate) processor: String,
    /// Its cores, as far as the program may use them.
    pub(crate) cores: usize,
    /// The operating system.
    pub(crate) system: String,
}

impl Report {
    /// A report made here and now.
    pub(super) fn new(project: &Project, build: Build, options: Options, formulas: Vec<Measurement>) -> Self {
        let (machine, sources) = (Machine::this(), sources(project));
        Self { version: VERSION, created: now(), sources, machine, build, options, formulas }
    }

    /// The measurement of this formula.
    pub(crate) fn formula(&self, id: &str) -> Option<&Measurement> {
        self.formulas.iter().find(|measurement| measurement.formula == id)
    }

    /// The part of the report about a family, as `slider`.
    pub(crate) fn of_family(&self, family: &str) -> Self {
        let belongs = |measurement: &&Measurement| measurement.formula.split('.').next() == Some(family);
        Self { formulas: self.formulas.iter().filter(belongs).cloned().collect(), ..self.clone() }
    }

    /// Whether it is about this version of the code.
    pub(crate) fn is_current(&self, project: &Project) -> bool {
        self.sources == sources(project)
    }

    /// The report in a file.
    pub(super) fn read(path: &Path) -> anyhow::Result<Self> {
        let shown = path.display();
        let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {shown}"))?;
        serde_json::from_str(&text)
            .with_context(|| format!("{shown} is not a report; `report --format json` writes one"))
    }

    /// The report kept for the book: the last one made here, or the reference, if it covers every formula.
    pub(crate) fn kept(project: &Project) -> Option<Self> {
        let is_whole = |report: &Self| project.catalog().iter().all(|one| report.formula(one.spec().id).is_some());
        [place(project), reference(project)].iter().filter_map(|path| Self::read(path).ok()).find(is_whole)
    }

    /// Keeps it for the book.
    pub(super) fn keep(&self, project: &Project) -> anyhow::Result<PathBuf> {
        let place = place(project);
        files::write(&place, &serde_json::to_string(self)?)?;
        Ok(place)
    }

    /// The part shown in the book and compared by `--against`: no columns, no ratios, and of hard points only the
    /// closed form's hardest.
    fn for_the_book(&self) -> Self {
        let mut report = self.clone();
        for measurement in &mut report.formulas {
            measurement.columns = None;
            for method in &mut measurement.methods {
                for figures in [&mut method.value, &mut method.jacobian].into_iter().flatten() {
                    figures.ratio = None;
                    let hardest = figures.hardest().filter(|_| method.id == "closed").cloned();
                    figures.hard_times = hardest.into_iter().collect();
                }
            }
        }
        report
    }

    /// Saves the part shown in the book as the reference, one formula per line, with as many digits as are meaningful.
    pub(super) fn keep_as_reference(&self, project: &Project) -> anyhow::Result<PathBuf> {
        let (place, mut all) = (reference(project), serde_json::to_value(self.for_the_book())?);
        shorten(&mut all);
        let formulas: Vec<_> = all["formulas"].take().as_array().into_iter().flatten().map(Value::to_string).collect();
        let text =
            all.to_string().replace("\"formulas\":null", &format!("\"formulas\":[\n{}\n]", formulas.join(",\n")));
        files::write(&place, &(text + "\n"))?;
        Ok(place)
    }
}

/// The file of the last report made here.
fn place(project: &Project) -> PathBuf {
    project.kept("report.json")
}

/// The file of the report that the book shows on a machine where none was made.
fn reference(project: &Project) -> PathBuf {
    project.root().join("book/report.json")
}

/// Rounds every number to four digits: no time is reproducible to more.
fn shorten(value: &mut Value) {
    match value {
        Value::Number(number) if number.is_f64() => {
            let short = number.as_f64().and_then(|x| format!("{x:.3e}").parse::<f64>().ok());
            *value = short.map_or(Value::Null, Value::from);
        }
        Value::Array(all) => all.iter_mut().for_each(shorten),
        Value::Object(all) => all.values_mut().for_each(shorten),
        _ => {}
    }
}

fn sources(project: &Project) -> String {
    format!("{:016x}", evidence::fingerprint(project))
}

impl Machine {
    fn this() -> Self {
        let cpuinfo = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let model = cpuinfo.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
        Self {
            processor: model.map_or_else(|| std::env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned()),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            system: std::env::consts::OS.to_owned(),
        }
    }
}

/// The time as `2025-06-01T12:34:56Z`.
fn now() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |elapsed| elapsed.as_secs());
    utc(seconds)
}

/// Converts seconds since 1970 to a date, by counting years of 366 or 365 days.
fn utc(seconds: u64) -> String {
    let leap = |year: u64| year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let (mut year, mut day) = (1970, seconds / 86400);
    while day >= 365 + u64::from(leap(year)) {
        day -= 365 + u64::from(leap(year));
        year += 1;
    }
    let mut month = 1;
    for days in [31, 28 + u64::from(leap(year)), 31, 30, 31, 30, 31, 31, 30, 31, 30] {
        if day < days {
            break;
        }
        day -= days;
        month += 1;
    }
    let [hour, minute, second] = [seconds / 3600 % 24, seconds / 60 % 60, seconds % 60];
    format!("{year:04}-{month:02}-{:02}T{hour:02}:{minute:02}:{second:02}Z", day + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_is_shown_where_nothing_was_measured() {
        let root = tempfile::tempdir().unwrap();
        let project = Project::new("referred", root.path().to_str().unwrap().to_owned().leak(), &[]);
        // In a shared target folder it outlives the test.
        let _ = std::fs::remove_file(place(&project));
        assert_eq!(Report::kept(&project), None);
        let report = crate::sample::report();
        let path = report.keep_as_reference(&project).unwrap();
        let reference = Report::kept(&project).unwrap();
        let whole = std::fs::read_to_string(path).unwrap();
        assert_eq!(whole.lines().count(), report.formulas.len() + 2, "{whole}");
        let mut short = serde_json::to_value(report.for_the_book()).unwrap();
        shorten(&mut short);
        assert_eq!(serde_json::to_value(&reference).unwrap(), short);
        // A measurement made here takes precedence.
        let here = Report { created: "later".into(), ..report };
        here.keep(&project).unwrap();
        assert_eq!(Report::kept(&project), Some(here));
    }

    #[test]
    fn numbers_are_shortened_to_four_digits() {
        let mut value = serde_json::json!({ "a": [1.234_56, -2.0, 0.0, 7, 1.5e-300], "b": { "c": "0.123456" } });
        shorten(&mut value);
        assert_eq!(value, serde_json::json!({ "a": [1.235, -2.0, 0.0, 7, 1.5e-300], "b": { "c": "0.123456" } }));
    }

    #[test]
    fn a_report_says_what_it_is_about_and_when_it_was_made() {
        let root = tempfile::tempdir().unwrap();
        let project = Project::new("made", root.path().to_str().unwrap().to_owned().leak(), &[]);
        let Report { build, options, formulas, .. } = crate::sample::report();
        let report = Report::new(&project, build, options, formulas);
        assert_eq!(report.version, 3);
        // As `2025-06-01T12:34:56Z`, later than this test was written.
        let shape: String = report.created.chars().map(|c| if c.is_ascii_digit() { '0' } else { c }).collect();
        assert_eq!(shape, "0000-00-00T00:00:00Z");
        assert!(report.created.as_str() > "2025", "{}", report.created);
        assert!(report.machine.cores > 0 && report.machine.system == std::env::consts::OS);
        assert!(report.sources.len() == 16 && report.is_current(&project));
        std::fs::create_dir(root.path().join("src")).unwrap();
        std::fs::write(root.path().join("src/lib.rs"), "other code").unwrap();
        assert!(!report.is_current(&project));
    }

    #[test]
    fn a_family_is_what_stands_before_the_dot() {
        let of =
            |family| crate::sample::report().of_family(family).formulas.into_iter().map(|one| one.formula).collect();
        let found: [Vec<String>; 3] = ["t", "u", "t.first"].map(of);
        assert_eq!(found, [vec!["t.first".to_owned()], vec!["u.second".to_owned()], Vec::new()]);
    }

    #[test]
    fn a_report_on_every_formula_alone_is_for_the_book() {
        let root = tempfile::tempdir().unwrap();
        let catalog = &jointproof::catalog::CATALOG[..2];
        let project = Project::new("whole", root.path().to_str().unwrap().to_owned().leak(), catalog);
        let formulas = catalog.iter().map(|formula| crate::sample::measurement(formula.spec().id, 1.0)).collect();
        let whole = Report { formulas, ..crate::sample::report() };
        for left_out in [0, 1] {
            let mut part = whole.clone();
            part.formulas.remove(left_out);
            part.keep(&project).unwrap();
            assert_eq!(Report::kept(&project), None);
        }
        whole.keep_as_reference(&project).unwrap();
        let kept = Report::kept(&project).unwrap();
        assert_eq!(kept.formulas.len(), 2, "the last one here is not about every formula");
        whole.keep(&project).unwrap();
        assert_eq!(Report::kept(&project), Some(whole));
    }

    #[test]
    fn dates_are_those_of_the_calendar() {
        assert_eq!(utc(0), "1970-01-01T00:00:00Z");
        assert_eq!(utc(31_536_000), "1971-01-01T00:00:00Z");
        assert_eq!(utc(2_678_399), "1970-01-31T23:59:59Z");
        assert_eq!(utc(2_678_400), "1970-02-01T00:00:00Z");
        assert_eq!(utc(951_782_399), "2000-02-28T23:59:59Z");
        assert_eq!(utc(951_782_400), "2000-02-29T00:00:00Z");
        assert_eq!(utc(1_735_689_599), "2024-12-31T23:59:59Z");
        assert_eq!(utc(4_107_542_400), "2100-03-01T00:00:00Z", "2100 is no leap year");
    }
}
