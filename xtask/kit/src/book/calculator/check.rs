//! The calculators of a built book, operated in a browser with the inputs of every golden case, and compared bit by bit.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, bail, ensure};
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::toolkit::verify::golden::{File, Record, components};
use serde_json::Value;

use super::MARK;
use super::sizes::{self, Sizes};
use crate::book::browser::{self, Browser};
use crate::console::count;
use crate::export::{self, Script};
use crate::project::Project;

#[cfg(test)]
mod tests;

/// The script executed in the page.
pub(super) const DRIVE: &str = include_str!("drive.js");

/// The result of the check.
#[derive(Default)]
pub(crate) struct Checked {
    formulas: usize,
    cases: usize,
    /// Cases that are in the menus.
    chosen: usize,
    numbers: usize,
    differ: usize,
    near: usize,
    refused: usize,
    /// Cases in which every single input is allowed, but which are rejected because of their combination.
    together: usize,
    eta: [f64; 2],
    sizes: Sizes,
    /// The differences, the worst first.
    off: Vec<String>,
}

impl Checked {
    pub(crate) fn is_well(&self) -> bool {
        self.numbers > 0 && self.chosen > 0 && self.off.is_empty()
    }
}

impl fmt::Display for Checked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { formulas, cases, chosen, numbers, differ, near, refused, together, eta, sizes, off } = self;
        write!(
            f,
            "{}: {}, {chosen} of them also from menus; ",
            count(*formulas, "calculator"),
            count(*cases, "golden case")
        )?;
        write!(f, "{} in Chromium, {differ} differ, {near} by its own functions alone; ", count(*numbers, "number"))?;
        write!(f, "{refused} refused in the same words, {together} by what is required of all inputs\n    ")?;
        write!(f, "golden values: η at most {:.2} of its bound, of Jacobians {:.2}; {sizes}", eta[0], eta[1])?;
        off.iter().take(5).try_for_each(|off| write!(f, "\n    {off}"))
    }
}

/// Checks every calculator of the book in this folder; `None` if there is no browser and none is required.
pub(crate) fn check(project: &Project, out: &Path) -> Result<Option<Checked>> {
    if !browser::is_here_or_not_required()? {
        return Ok(None);
    }
    use_all(project, out, &mut Browser::start()?).map(Some)
}

/// Checks every calculator with this browser.
pub(super) fn use_all(project: &Project, out: &Path, browser: &mut Browser) -> Result<Checked> {
    let out = out.canonicalize()?;
    let mut checked = Checked::default();
    for page in pages(&out)? {
        let text = fs::read_to_string(&page)?;
        let ids = calculators(&text);
        if ids.is_empty() {
            continue;
        }
        browser.open(&page)?;
        browser.evaluate(DRIVE)?;
        for id in ids {
            let formula = project.find(&id).with_context(|| format!("there is no formula {id}"))?;
            let golden = File::parse(&fs::read_to_string(project.golden_file(&id))?)?;
            checked.formulas += 1;
            One { formula, golden: &golden, checked: &mut checked }.compare(browser)?;
        }
        let faults: Vec<String> = serde_json::from_value(browser.evaluate("faultsOnPhone()")?)?;
        checked.off.extend(faults.into_iter().map(|fault| format!("{} on a phone: {fault}", project.shown(&page))));
        checked.off.append(&mut browser.errors);
    }
    checked.sizes = Sizes::of(&out, browser)?;
    if checked.sizes.all.len() != checked.formulas {
        checked.off.push(format!("{} scripts for {} calculators", checked.sizes.all.len(), checked.formulas));
    }
    if checked.sizes.shared > sizes::WANTED {
        checked.off.push(format!("calculators without formulas have {} bytes", checked.sizes.shared));
    }
    Ok(checked)
}

/// The formulas whose calculators are on a page.
fn calculators(page: &str) -> Vec<String> {
    let begin = format!("{MARK} data-formula=\"");
    let id = |rest: &str| rest.split_once('"').map(|(id, _)| id.to_owned());
    page.split(&begin).skip(1).filter_map(id).collect()
}

/// The pages of chapters, without listings and the page that repeats all chapters.
pub(crate) fn pages(out: &Path) -> Result<Vec<PathBuf>> {
    let mut pages = Vec::new();
    for entry in fs::read_dir(out)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default();
        if path.extension().is_some_and(|extension| extension == "html") && name != "print.html" && name != "index.html"
        {
            pages.push(path);
        }
    }
    pages.sort();
    Ok(pages)
}

/// One formula.
struct One<'a> {
    formula: &'static dyn AnyFormula,
    golden: &'a File,
    checked: &'a mut Checked,
}

/// The contents of a calculator.
#[derive(serde::Deserialize)]
struct Shown {
    refusal: String,
    numbers: Vec<String>,
    /// The fields after the case is chosen from the menu; `None` if it is not in the menu.
    chosen: Option<Vec<String>>,
    /// Whether the results are then the same.
    #[serde(default)]
    same: bool,
}

impl One<'_> {
    fn compare(&mut self, browser: &mut Browser) -> Result<()> {
        let id = self.formula.spec().id;
        let mut points = Vec::new();
        for case in &self.golden.cases {
            points.push(components(self.formula.inputs(), &case.inputs)?);
        }
        // Every other case uses hexadecimal digits.
        let texts = points.iter().enumerate().map(|(k, point)| {
            let text = |x: &f64| if k % 2 == 0 { format!("{x:?}") } else { hexadecimal(*x) };
            point.iter().map(text).collect::<Vec<_>>()
        });
        let texts: Vec<_> = texts.collect();
        let names: Vec<_> = self.golden.cases.iter().map(|case| case.id.as_str()).collect();
        let [texts, names] = [serde_json::to_string(&texts)?, serde_json::to_string(&names)?];
        let shown = browser.evaluate(&format!("drive('{id}', {texts}, {names})"))?;
        let shown: Vec<Shown> = serde_json::from_value(shown).with_context(|| format!("{id} shows something else"))?;
        ensure!(shown.len() == points.len(), "{id} shows {} of {} cases", shown.len(), points.len());
        for ((case, point), shown) in self.golden.cases.iter().zip(&points).zip(&shown) {
            self.case(case, point, shown)?;
        }
        Ok(())
    }

    fn case(&mut self, case: &Record, point: &[f64], shown: &Shown) -> Result<()> {
        self.checked.cases += 1;
        if let Some(fields) = &shown.chosen {
            self.checked.chosen += 1;
            let is_field =
                |(text, x): (&String, &f64)| text.parse().is_ok_and(|field: f64| field.to_bits() == x.to_bits());
            if !shown.same || !fields.iter().zip(point).all(is_field) {
                self.off(case, "chosen from the menu, it shows something else");
            }
        }
        let (value, jacobian) = match self.formula.value_and_closed_jacobian(point) {
            Ok(both) => both,
            Err(error) => {
                let said = error.to_string();
                if shown.refusal == said {
                    self.checked.refused += 1;
                } else if self.are_allowed(point)
                    && shown.refusal == format!("Refused; required is {}", error.required())
                {
                    self.checked.together += 1;
                } else {
                    self.off(case, &format!("it says {:?}, and Rust {said:?}", shown.refusal));
                }
                return Ok(());
            }
        };
        if !shown.refusal.is_empty() {
            self.off(case, &format!("it refuses what is valid: {}", shown.refusal));
            return Ok(());
        }
        let expected = [value, jacobian].concat();
        if shown.numbers.len() != expected.len() {
            self.off(case, &format!("it shows {} of {} numbers", shown.numbers.len(), expected.len()));
            return Ok(());
        }
        let golden = self.exact(case);
        for (k, (text, expected)) in shown.numbers.iter().zip(&expected).enumerate() {
            let Ok(found) = text.parse::<f64>() else { bail!("{text:?} is no number") };
            self.number(case, k, found, *expected)?;
            if let Some((exact, scale, is_value)) = golden.get(k).copied().flatten() {
                self.accuracy((case, k), found, exact, scale, is_value)?;
            }
        }
        Ok(())
    }

    fn number(&mut self, case: &Record, k: usize, found: f64, expected: f64) -> Result<()> {
        self.checked.numbers += 1;
        if found.to_bits() == expected.to_bits() {
            return Ok(());
        }
        if self.script()?.is_near(found, expected) {
            self.checked.near += 1;
            return Ok(());
        }
        self.checked.differ += 1;
        let entry = self.script()?.entry(k);
        self.off(case, &format!("{entry}: {found:e}, expected {expected:e}"));
        Ok(())
    }

    /// The exported script of the formula, needed only if there is a difference.
    fn script(&self) -> Result<Script> {
        export::script(self.formula).map_err(|why| anyhow::anyhow!("{} has no script: {why}", self.formula.spec().id))
    }

    fn accuracy(
        &mut self,
        (case, k): (&Record, usize),
        found: f64,
        exact: f64,
        scale: f64,
        is_value: bool,
    ) -> Result<()> {
        let bounds = self.golden.eta;
        let (at, bound) = if is_value { (0, bounds.value) } else { (1, bounds.jacobian.unwrap_or_default()) };
        let eta = eta(found, exact, scale);
        if eta > bound {
            let entry = self.script()?.entry(k);
            self.off(case, &format!("{entry}: η = {eta:.2} of the golden number, stated is {bound}"));
        } else if bound > 0.0 {
            self.checked.eta[at] = self.checked.eta[at].max(eta / bound);
        }
        Ok(())
    }

    /// The golden numbers in the order of the calculator, each with its scale; `None` if the case has none.
    fn exact(&self, case: &Record) -> Vec<Option<(f64, f64, bool)>> {
        let (inputs, outputs) = (self.formula.inputs(), self.formula.outputs());
        let values = |map: &Option<serde_json::Map<String, Value>>| -> Vec<f64> {
            map.iter().flat_map(|map| outputs.iter().flat_map(|field| leaves(&map[field.name]))).collect()
        };
        let entries = |map: &Option<serde_json::Map<String, Value>>| -> Vec<f64> {
            map.iter()
                .flat_map(|map| outputs.iter().flat_map(|output| rows(&map[output.name], output, inputs)))
                .collect()
        };
        let of_value =
            values(&case.out).into_iter().zip(values(&case.out_scale)).map(|(x, scale)| Some((x, scale, true)));
        let of_jacobian =
            entries(&case.jac).into_iter().zip(entries(&case.jac_scale)).map(|(x, scale)| Some((x, scale, false)));
        of_value.chain(of_jacobian).collect()
    }

    /// Whether every single input is allowed.
    fn are_allowed(&self, point: &[f64]) -> bool {
        let domains = self.formula.inputs().iter().flat_map(|field| vec![field.quantity.domain; field.len()]);
        point.iter().zip(domains).all(|(x, domain)| x.is_finite() && domain.allows(*x))
    }

    fn off(&mut self, case: &Record, what: &str) {
        self.checked.off.push(format!("{}, case {}: {what}", self.formula.spec().id, case.id));
    }
}

/// The backward error, η = |ŷ − y| / (u · scale + half the smallest subnormal), with numerator and denominator doubled.
fn eta(found: f64, exact: f64, scale: f64) -> f64 {
    2.0 * (found - exact).abs() / (f64::EPSILON * scale + f64::from_bits(1))
}

/// The rows of a Jacobian that belong to an output, each over all inputs.
fn rows(of_output: &Value, output: &Field, inputs: &[Field]) -> Vec<f64> {
    let columns: Vec<_> = inputs.iter().map(|input| (input.len(), leaves(&of_output[input.name]))).collect();
    let row = |k: usize| columns.iter().flat_map(move |(len, all)| all[k * len..(k + 1) * len].iter().copied());
    (0..output.len()).flat_map(row).collect()
}

/// The numbers in nested lists.
fn leaves(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(parts) => parts.iter().flat_map(leaves).collect(),
        Value::String(word) => word.parse().into_iter().collect(),
        number => number.as_f64().into_iter().collect(),
    }
}

/// A double in hexadecimal notation, as printed by C.
fn hexadecimal(x: f64) -> String {
    if !x.is_finite() {
        return format!("{x:?}");
    }
    let sign = if x.is_sign_negative() { "-" } else { "" };
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff).cast_signed(), bits & 0xf_ffff_ffff_ffff);
    let (lead, exponent) = if exponent == 0 { (0, -1022) } else { (1, exponent - 1023) };
    format!("{sign}0x{lead}.{fraction:013x}p{exponent:+}")
}
