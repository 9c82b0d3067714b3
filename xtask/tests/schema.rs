//! The schema of golden files accepts all of them and rejects everything else.

use crate::common;
use jsonschema::Validator;
use serde_json::{Value, json};
use std::fs;

fn schema() -> Value {
    let text = fs::read_to_string(common::repository().join("golden/schema.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn validator() -> Validator {
    jsonschema::draft202012::new(&schema()).unwrap()
}

/// Every golden file by name.
fn golden() -> Vec<(String, Value)> {
    let files = fs::read_dir(common::repository().join("golden")).unwrap().map(|entry| entry.unwrap().path());
    let golden = files.filter(|path| path.extension().is_some_and(|x| x == "json") && !path.ends_with("schema.json"));
    golden
        .map(|path| {
            let value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
            (path.file_name().unwrap().to_string_lossy().into_owned(), value)
        })
        .collect()
}

fn faults(validator: &Validator, file: &Value) -> Vec<String> {
    validator.iter_errors(file).map(|error| format!("{}: {error}", error.instance_path())).collect()
}

#[test]
fn the_schema_is_one_of_draft_2020_12() {
    let schema = schema();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    if let Err(error) = jsonschema::meta::validate(&schema) {
        panic!("{}: {error}", error.instance_path());
    }
}

#[test]
fn every_property_and_definition_is_described() {
    fn visit(path: &str, value: &Value) {
        for group in ["properties", "$defs"] {
            for (name, of) in value[group].as_object().into_iter().flatten() {
                let path = format!("{path}/{name}");
                assert!(of["description"].is_string(), "{path} has no description");
                visit(&path, of);
            }
        }
    }
    visit("", &schema());
}

#[test]
fn every_golden_file_is_valid() {
    let validator = validator();
    let golden = golden();
    assert!(!golden.is_empty());
    for (name, file) in golden {
        assert_eq!(faults(&validator, &file), [""; 0], "{name}");
    }
}

/// The golden file that the mutations start from, with a scalar and a vector among its inputs.
fn original() -> Value {
    golden().into_iter().find(|(name, _)| name == "slot.kinetic_force.json").unwrap().1
}

/// The index of the first case with this flag.
fn case(file: &Value, flag: &str) -> usize {
    let flagged = |case: &Value| case["flags"].as_array().unwrap().contains(&flag.into());
    file["cases"].as_array().unwrap().iter().position(flagged).unwrap()
}

/// A mutation of the file, of a valid case and of an invalid one.
type Mutation = fn(file: &mut Value, valid: usize, invalid: usize);

fn remove(object: &mut Value, key: &str) {
    assert!(object.as_object_mut().unwrap().remove(key).is_some(), "there was no {key}");
}

#[test]
fn whatever_is_not_as_laid_down_is_refused() {
    let mutations: [(&str, Mutation); 45] = [
        ("an extra key", |f, _, _| f["author"] = json!("me")),
        ("an extra key in a case", |f, v, _| f["cases"][v]["note"] = json!("x")),
        ("an extra key in an input", |f, _, _| f["inputs"][0]["latex"] = json!("x")),
        ("no formula", |f, _, _| remove(f, "formula")),
        ("no layout", |f, _, _| remove(f, "layout")),
        ("another layout", |f, _, _| f["layout"] = json!(1)),
        ("no provenance", |f, _, _| remove(f, "provenance")),
        ("another provenance", |f, _, _| f["provenance"] = json!({"kind": "found"})),
        ("ours without a reason", |f, _, _| f["provenance"] = json!({"kind": "ours"})),
        ("printed for a reason", |f, _, _| f["provenance"] = json!({"kind": "printed", "why": "x"})),
        ("a negative bound", |f, _, _| f["eta"]["value"] = json!(-1.0)),
        ("another schema", |f, _, _| f["schema"] = json!("http://example.org/schema.json")),
        ("an identifier without a room", |f, _, _| f["formula"] = json!("kinetic_force")),
        ("an empty title", |f, _, _| f["title"] = json!("")),
        ("no inputs", |f, _, _| f["inputs"] = json!([])),
        ("no outputs", |f, _, _| f["outputs"] = json!([])),
        ("a name with a blank", |f, _, _| f["inputs"][0]["name"] = json!("f 1")),
        ("a unit that is none", |f, _, _| f["inputs"][0]["unit"] = json!("N/mm")),
        ("a shape of three dimensions", |f, _, _| f["inputs"][0]["shape"] = json!([3, 3, 3])),
        ("a shape of one", |f, _, _| f["inputs"][0]["shape"] = json!([1])),
        ("a negative shape", |f, _, _| f["inputs"][0]["shape"] = json!([-3])),
        ("too few cases", |f, _, _| f["cases"].as_array_mut().unwrap().truncate(31)),
        ("no in", |f, v, _| remove(&mut f["cases"][v], "in")),
        ("an empty in", |f, v, _| f["cases"][v]["in"] = json!({})),
        ("a number as text", |f, v, _| f["cases"][v]["in"]["f1"] = json!("1.0")),
        ("NaN in other letters", |f, v, _| f["cases"][v]["in"]["f1"] = json!("nan")),
        ("null for a number", |f, v, _| f["cases"][v]["in"]["f1"] = json!(null)),
        ("text in a column", |f, v, _| f["cases"][v]["in"]["e1a"][2] = json!("1.0")),
        ("rows in a column", |f, v, _| f["cases"][v]["in"]["e1a"] = json!([[1.0, 0.0, 0.0]])),
        ("a column of one", |f, v, _| f["cases"][v]["in"]["e1a"] = json!([1.0])),
        ("a result that is not finite", |f, v, _| f["cases"][v]["out"]["f"][0] = json!("Infinity")),
        ("a Jacobian without inputs", |f, v, _| f["cases"][v]["jac"]["f"] = json!([1.0, 0.0, 0.0])),
        ("a Jacobian that is not finite", |f, v, _| f["cases"][v]["jac"]["f"]["f1"][0] = json!("NaN")),
        ("a Jacobian of text", |f, v, _| f["cases"][v]["jac"]["f"]["e1a"][0][0] = json!("1.0")),
        ("a negative scale", |f, v, _| f["cases"][v]["out_scale"]["f"][0] = json!(-1.0)),
        ("a scale that is no number", |f, v, _| f["cases"][v]["jac_scale"]["f"]["f1"][0] = json!("NaN")),
        ("an unknown flag", |f, v, _| f["cases"][v]["flags"] = json!(["easy"])),
        ("no flag", |f, v, _| f["cases"][v]["flags"] = json!([])),
        ("the same flag twice", |f, v, _| f["cases"][v]["flags"] = json!(["hand", "hand"])),
        ("a valid case without out", |f, v, _| remove(&mut f["cases"][v], "out")),
        ("a valid case without out_scale", |f, v, _| remove(&mut f["cases"][v], "out_scale")),
        ("a Jacobian without its scale", |f, v, _| remove(&mut f["cases"][v], "jac_scale")),
        ("a valid case without jac, on no kink", |f, v, _| remove(&mut f["cases"][v], "jac")),
        ("an invalid case without error", |f, _, i| remove(&mut f["cases"][i], "error")),
        ("an invalid case with a result", |f, v, i| f["cases"][i]["out"] = f["cases"][v]["out"].clone()),
    ];
    let (validator, original) = (validator(), original());
    let (valid, invalid) = (case(&original, "hand"), case(&original, "invalid"));
    for (what, mutate) in mutations {
        let mut file = original.clone();
        mutate(&mut file, valid, invalid);
        assert_ne!(file, original, "{what} changes nothing");
        assert!(!validator.is_valid(&file), "{what} is accepted");
    }
}

#[test]
fn what_may_differ_is_accepted() {
    let changes: [(&str, Mutation); 10] = [
        ("no comment", |f, v, _| remove(&mut f["cases"][v], "comment")),
        ("an input that is not finite", |f, v, _| f["cases"][v]["in"]["e1a"][0] = json!("-Infinity")),
        ("an integer", |f, v, _| f["cases"][v]["in"]["f1"] = json!(1)),
        ("no jac on a kink", |f, v, _| {
            f["cases"][v]["flags"] = json!(["hard", "kink"]);
            remove(&mut f["cases"][v], "jac");
            remove(&mut f["cases"][v], "jac_scale");
        }),
        ("a scale beyond all doubles", |f, v, _| f["cases"][v]["jac_scale"]["f"]["f1"][0] = json!("Infinity")),
        ("a reconstructed equation", |f, _, _| f["provenance"] = json!({"kind": "reconstructed", "why": "the root"})),
        ("a matrix", |f, v, _| {
            f["inputs"][0]["shape"] = json!([3, 3]);
            f["cases"][v]["in"]["e1a"] = json!([[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
        }),
        ("the derivative of a matrix with respect to a matrix", |f, v, _| {
            f["cases"][v]["jac"]["f"]["e1a"] =
                json!([[[[0, 1], [1, 0]], [[1, 0], [0, 1]]], [[[0, 0], [0, 0]], [[0, 0], [1, 1]]]]);
        }),
        ("the unit of a conductance", |f, _, _| f["inputs"][0]["unit"] = json!("F/LTΘ")),
        ("the unit of damping", |f, _, _| f["inputs"][0]["unit"] = json!("FT/L^3")),
    ];
    let (validator, original) = (validator(), original());
    let (valid, invalid) = (case(&original, "hand"), case(&original, "invalid"));
    for (what, change) in changes {
        let mut file = original.clone();
        change(&mut file, valid, invalid);
        assert_eq!(faults(&validator, &file), [""; 0], "{what}");
    }
}
