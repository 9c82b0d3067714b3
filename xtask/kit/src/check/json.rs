//! Questions and answers as JSON lines.

use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::toolkit::verify::golden::named;
use judge::{Answer, Question, Wanted};
use serde_json::{Value, json};

/// The first line: the formula, the requested results, and the fields in order.
pub(super) fn head(formula: &dyn AnyFormula, wanted: Wanted) -> String {
    let fields = |fields: &[Field]| -> Vec<Value> {
        let field = |field: &Field| json!({ "name": field.name, "shape": field.quantity.shape.dimensions() });
        fields.iter().map(field).collect()
    };
    let (id, inputs, outputs) = (formula.spec().id, fields(formula.inputs()), fields(formula.outputs()));
    let wanted = wanted.name();
    json!({ "cmd": "start", "version": 1, "formula": id, "wanted": wanted, "inputs": inputs, "outputs": outputs })
        .to_string()
}

/// A question with its number.
pub(super) fn question(formula: &dyn AnyFormula, k: usize, question: &Question) -> String {
    let mut line = json!({ "seq": k, "in": named(formula.inputs(), &question.inputs) });
    if let Some([v, w]) = &question.directions {
        line["v"] = json!(v);
        line["w"] = json!(w);
    }
    line.to_string()
}

/// Reads the answer to the question with this number.
pub(super) fn read(formula: &dyn AnyFormula, wanted: Wanted, k: usize, line: &str) -> Answer {
    let Ok(answer) = serde_json::from_str::<Value>(line) else {
        return Answer::Bad("no JSON".into());
    };
    if answer["seq"] != json!(k) {
        return Answer::Bad(format!("has the number {} instead of {k}", answer["seq"]));
    }
    if let Some(refused) = answer.get("refuse") {
        return Answer::Refused(refused.as_str().map(str::to_owned));
    }
    if let Some(why) = answer.get("skipped") {
        return Answer::Skipped(why.as_str().unwrap_or_default().to_owned());
    }
    match numbers(formula, wanted, &answer) {
        Ok(numbers) => Answer::Numbers(numbers),
        Err(what) => Answer::Bad(what),
    }
}

fn numbers(formula: &dyn AnyFormula, wanted: Wanted, answer: &Value) -> Result<Vec<Option<f64>>, String> {
    let (inputs, outputs) = (formula.inputs(), formula.outputs());
    let count = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
    let (n, m) = (count(inputs), count(outputs));
    let of = |name: &str, expected: usize| {
        let mut numbers = Vec::new();
        match &answer[name] {
            Value::Object(_) if name == "out" => in_order(outputs, &answer[name], &mut numbers)?,
            Value::Object(_) if name == "jac" => numbers = by_name(inputs, outputs, &answer[name])?,
            list => flatten(list, &mut numbers)?,
        }
        let found = numbers.len();
        if found == expected { Ok(numbers) } else { Err(format!("{found} numbers in `{name}` instead of {expected}")) }
    };
    let mut all = of("out", m)?;
    match wanted {
        Wanted::Value => {}
        Wanted::Jacobian => all.extend(of("jac", m * n)?),
        Wanted::Products => {
            all.extend(of("jv", m)?);
            all.extend(of("wj", n)?);
        }
    }
    Ok(all)
}

fn in_order(fields: &[Field], object: &Value, into: &mut Vec<Option<f64>>) -> Result<(), String> {
    fields.iter().try_for_each(|field| flatten(&object[field.name], into))
}

/// `jac[out][in]`, nested by the shape of the output and within it by that of the input, output by output.
fn by_name(inputs: &[Field], outputs: &[Field], object: &Value) -> Result<Vec<Option<f64>>, String> {
    let mut rows = Vec::new();
    for output in outputs {
        let mut blocks = Vec::new();
        for input in inputs {
            let mut block = Vec::new();
            flatten(&object[output.name][input.name], &mut block)?;
            let (found, expected) = (block.len(), output.len() * input.len());
            if found != expected {
                let place = format!("jac.{}.{}", output.name, input.name);
                return Err(format!("{found} numbers in `{place}` instead of {expected}"));
            }
            blocks.push((block, input.len()));
        }
        for row in 0..output.len() {
            rows.extend(blocks.iter().flat_map(|(block, width)| &block[row * width..][..*width]));
        }
    }
    Ok(rows)
}

/// Numbers in nested lists; `null` for one that is not computed.
fn flatten(value: &Value, into: &mut Vec<Option<f64>>) -> Result<(), String> {
    match value {
        Value::Array(parts) => parts.iter().try_for_each(|part| flatten(part, into)),
        Value::Null => {
            into.push(None);
            Ok(())
        }
        value => {
            let special = value.as_str().and_then(|text| text.parse().ok());
            let number: Option<f64> = value.as_f64().or(special);
            into.push(Some(number.ok_or_else(|| format!("{value} is no number"))?));
            Ok(())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::find;

    fn answer(id: &str, line: &str) -> Answer {
        read(find(id).unwrap(), Wanted::Jacobian, 3, line)
    }

    #[test]
    fn what_a_golden_file_says_is_an_answer() {
        let formula = find("slider.line").unwrap();
        let case = formula.golden().cases.into_iter().find(|case| case.jac.is_some()).unwrap();
        let line = json!({ "seq": 3, "out": case.out, "jac": case.jac }).to_string();
        let inputs = jointproof::toolkit::verify::golden::components(formula.inputs(), &case.inputs).unwrap();
        let (value, jacobian) = formula.value_and_jacobian(&inputs).unwrap();
        let Answer::Numbers(found) = answer("slider.line", &line) else { panic!() };
        assert_eq!(found.len(), value.len() + jacobian.len());
        for (found, own) in found.into_iter().flatten().zip([value, jacobian].concat()) {
            assert!((found - own).abs() < 1e-12 * (1.0 + own.abs()), "{found} {own}");
        }
    }

    #[test]
    fn lists_do_as_well_and_what_is_wrong_is_named() {
        let numbers = |numbers: &[f64]| Answer::Numbers(numbers.iter().copied().map(Some).collect());
        let id = "slot.contact_force";
        assert_eq!(answer(id, r#"{"seq":3,"out":5,"jac":[0.6,0.8]}"#), numbers(&[5.0, 0.6, 0.8]));
        assert_eq!(answer(id, r#"{"seq":3,"out":[5],"jac":[["Infinity",0.8]]}"#), numbers(&[5.0, f64::INFINITY, 0.8]));
        let with_gap = Answer::Numbers(vec![Some(5.0), None, Some(0.8)]);
        assert_eq!(answer(id, r#"{"seq":3,"out":5,"jac":[null,0.8]}"#), with_gap);
        assert_eq!(answer(id, r#"{"seq":3,"refuse":"f2"}"#), Answer::Refused(Some("f2".into())));
        assert_eq!(answer(id, r#"{"seq":3,"skipped":"not yet"}"#), Answer::Skipped("not yet".into()));
        let products = r#"{"seq":3,"out":5,"jv":[1],"wj":[0.25,0.5]}"#;
        assert_eq!(read(find(id).unwrap(), Wanted::Products, 3, products), numbers(&[5.0, 1.0, 0.25, 0.5]));
        let bad = |line| match answer(id, line) {
            Answer::Bad(what) => what,
            other => panic!("{other:?}"),
        };
        assert_eq!(bad("5 0.6 0.8"), "no JSON");
        assert_eq!(bad(r#"{"seq":4,"out":5,"jac":[0,0]}"#), "has the number 4 instead of 3");
        assert_eq!(bad(r#"{"seq":3,"out":5,"jac":[0]}"#), "1 numbers in `jac` instead of 2");
    }
}
