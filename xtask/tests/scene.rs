//! `cargo xtask scene`: its output, its error messages, and the schema of its files.

use crate::common::{Bench, Ran, repository};
use serde_json::{Value, json};
use std::fs;

const TELESCOPE: &str = "golden/scenes/telescope.json";
const WRONG: &str = r#"{
  "dimension": "3d",
  "nodes": { "a": { "at": [0, 0] } },
  "elements": { "s": { "kind": "slot", "nodes": ["a", "b"], "mu": -1 } },
  "outputs": ["U1"]
}"#;

/// The path of a scene in the repository.
fn scene(name: &str) -> String {
    repository().join("golden/scenes").join(name).to_string_lossy().into_owned()
}

#[test]
fn all_mistakes_are_said_with_their_places_and_nothing_is_written() {
    let bench = Bench::new();
    let (wrong, plots) = (bench.path("wrong.json"), bench.path("plots"));
    fs::write(&wrong, WRONG).unwrap();
    let (wrong, folder) = (wrong.to_string_lossy(), plots.to_string_lossy());
    // A correct scene does not run if given together with an incorrect one.
    let ran = bench.run(&["scene", &scene("rail.json"), &wrong, "--plot", &folder]).exits(1);
    assert_eq!(ran.stdout, "");
    assert!(!plots.exists());
    ran.says("wrong.json: nodes.a.at (line 3, column 27): an array of 2; allowed is an array of 3 numbers\n")
        .says("wrong.json: elements.s.nodes[1] (line 4, column 55): no node \"b\"; allowed is one of \"a\"\n")
        .says("wrong.json: elements.s.mu (line 4, column 67): -1; allowed is a finite number ≥ 0\n")
        .says("wrong.json: 3 faults\n");
    let one = r#"{ "dimension": "3d", "nodes": {}, "elements": {}, "outputs": ["U9"] }"#;
    fs::write(bench.path("wrong.json"), one).unwrap();
    bench.run(&["scene", &wrong]).exits(1).says("wrong.json: 1 fault\n");
}

#[test]
fn what_is_ambiguous_is_said_and_fails_on_request() {
    let bench = Bench::new();
    let path = bench.path("hinge.json");
    let of = |outputs: &str| {
        let scene = format!(
            r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}}},
            "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [0, 0, 0]}}}},
            "elements": {{"e": {{"kind": "hinge", "nodes": ["a", "b"], "theta1_ref": 90}}}},
            "frames": [{{"time": 1, "nodes": {{"b": {{"ur": [1, 0, 0]}}}}}}, {{"time": 1, "nodes": {{"b": {{"ur": [0, 4, 0]}}}}}}],
            "outputs": {outputs}}}"#
        );
        fs::write(&path, scene).unwrap();
    };
    of(r#"["UR1MAT"]"#);
    let path = path.to_string_lossy();
    let ran = bench.run(&["scene", &path, "--format", "json"]).exits(0);
    ran.says("hinge.json: elements.e.theta1_ref is 90, more than a full turn")
        .says("hinge.json: frames[1], node \"b\"");
    bench.run(&["scene", &path, "--format", "csv", "--deny-warnings"]).exits(1).says("frames[1], node \"b\"");
    of("[]");
    bench.run(&["scene", &path]).bad_usage("no outputs are wanted, so nothing would be computed; name some of ");
}

/// A file that is not written is not blamed for a state that cannot be evaluated.
#[test]
fn a_state_without_a_result_is_told_as_such_whatever_is_written() {
    let bench = Bench::new();
    let path = bench.path("align.json");
    let scene = r#"{"dimension": "3d", "orientations": {"o": {"rotation": [0, 0, 0]}},
        "nodes": {"a": {"at": [0, 0, 0], "orientation": "o"}, "b": {"at": [0, 0, 0]}},
        "elements": {"e": {"kind": "align", "nodes": ["a", "b"]}}, "outputs": ["ALPHA"],
        "frames": [{"time": 0}, {"time": 1, "nodes": {"b": {"ur": [0, 1.5707963267948966, 0]}}}]}"#;
    fs::write(&path, scene).unwrap();
    let path = path.to_string_lossy();
    for out in ["x.csv", "x.npz", "x.json"] {
        let out = bench.path(out);
        let ran = bench.run(&["scene", &path, "--out", &out.to_string_lossy()]).exits(1);
        ran.says("error: element \"e\", frames[1], scene.angles: node \"b\" against node \"a\": beta is 1.5707");
        assert!(!out.exists());
    }
}

#[test]
fn a_table_is_a_history() {
    let bench = Bench::new();
    let [table, model, out] = ["u.csv", "rail.json", "out.csv"].map(|name| bench.path(name));
    let mut scene: Value = serde_json::from_str(&fs::read_to_string(scene("rail.json")).unwrap()).unwrap();
    scene.as_object_mut().unwrap().remove("frames");
    scene["outputs"] = json!(["CU1"]);
    fs::write(&model, scene.to_string()).unwrap();
    fs::write(&table, "Time,Node Label,U1,S-Mises\n1,car,0.5,7\n2,car,0.75,8\n2,bus,1,9\n").unwrap();
    let [model, table, out] = [model, table, out].map(|path| path.to_string_lossy().into_owned());
    let ran = bench.run(&["scene", &model, "--history", &table, "--out", &out]).exits(0);
    ran.says("u.csv: the columns S-Mises are not used")
        .says("u.csv: 1 rows name no node of the scene, the first in line 4 \"bus\"; they are ignored");
    let written = fs::read_to_string(&out).unwrap();
    assert!(
        written.starts_with("time,element,output,component,value\n1.0,") && written.contains(",U1,0,0.75\n"),
        "{written}"
    );
    fs::write(&table, "time,node,u1\n1,car,half\n").unwrap();
    bench
        .run(&["scene", &model, "--history", &table])
        .exits(1)
        .says("line 2, column 3 (\"u1\"): \"half\"; allowed is a finite number");
}

#[test]
fn text_has_a_table_for_every_output() {
    let ran = Bench::new().run(&["scene", &scene("rail.json")]).quiet();
    for heading in ["A car on a rail", "U1  ", "FN  ", "CSF1  ", "CASU1  ", "formulas evaluated"] {
        assert!(ran.stdout.contains(heading), "{heading}: {}", ran.stdout);
    }
}

/// UR1, FR and FBEND have different meanings in a UJOINT and in a TRANSLATOR: each is described for the element shown.
#[test]
fn every_output_is_called_what_it_is_of_its_own_connector() {
    let bench = Bench::new();
    let path = bench.path("labels.json");
    let scene = |elements: &str| {
        format!(
            r#"{{"dimension": "3d", "orientations": {{"o": {{"rotation": [0, 0, 0]}}}},
            "nodes": {{"a": {{"at": [0, 0, 0], "orientation": "o"}}, "b": {{"at": [1, 0, 0]}}}},
            "elements": {{{elements}}}, "outputs": ["UR1", "FR", "FBEND"]}}"#
        )
    };
    let [joint, slide] =
        ["ujoint", "translator"].map(|kind| format!(r#""{kind}": {{"kind": "{kind}", "l": 1, "nodes": ["a", "b"]}}"#));
    let joint = joint.replace(r#""l": 1, "#, "");
    let said = |elements: &str| {
        fs::write(&path, scene(elements)).unwrap();
        bench.run(&["scene", &path.to_string_lossy()]).quiet().stdout
    };
    let alone = said(&joint);
    for words in ["available rotation about e1a", "magnitude of the force that JOIN transmits", "which bends its arms"]
    {
        assert!(alone.contains(words), "{words}: {alone}");
    }
    assert!(!alone.contains("residual"), "{alone}");
    let both = said(&format!("{joint}, {slide}"));
    assert!(
        both.contains("UR1  ujoint: available rotation") && both.contains("; translator: constraint residual"),
        "{both}"
    );
}

#[test]
fn errors_stand_beside_the_numbers() {
    let file = scene("telescope.json");
    let ran = Bench::new().run(&["scene", &file, "--error", "--format", "csv"]).exits(0).says("µs in f64");
    assert!(!ran.stderr.contains(", 0.0 µs in 237 bits"), "{}", ran.stderr);
    let mut lines = ran.stdout.lines();
    assert_eq!(lines.next(), Some("time,element,output,component,value,error"));
    let errors: Vec<f64> = lines.map(|line| line.rsplit(',').next().unwrap().parse().unwrap()).collect();
    assert!(errors.iter().all(|error| error.abs() < 1e-9) && errors.iter().any(|error| *error != 0.0));
}

#[test]
fn json_reads_back_as_the_library_gives_it() {
    let ran = Bench::new().run(&["scene", &scene("rail.json"), "--format", "json"]).quiet();
    let value: Value = serde_json::from_str(&ran.stdout).unwrap();
    assert_eq!(value["times"], json!([1.0, 2.0]));
    assert_eq!(value["counts"]["slot.contact_force"], 2);
    assert_eq!(value["series"][0]["output"], "U1");
    assert_eq!(value["series"][0]["values"][1], json!([2.5]));
}

#[test]
fn several_scenes_are_one_json_document() {
    let (rail, interface) = (scene("rail.json"), scene("interface.json"));
    let document = |more: &[&str]| -> Vec<Value> {
        let ran = Bench::new().run(&[&["scene", "--format", "json", &rail, &interface], more].concat()).quiet();
        serde_json::from_str(&ran.stdout).unwrap()
    };
    let titles: Vec<_> = document(&[]).iter().map(|scene| scene["title"].clone()).collect();
    assert!(titles.len() == 2 && titles[0] == "A car on a rail" && titles[1].is_string(), "{titles:?}");
    assert_eq!(document(&["--plan"]).len(), 2);
}

#[test]
fn a_scene_comes_from_standard_input() {
    let bench = Bench::new();
    let wrong = bench.path("wrong.json");
    fs::write(&wrong, WRONG).unwrap();
    let from = |path: &str| {
        let input = fs::File::open(path).unwrap();
        Ran::from(bench.command(&["scene", "-"]).stdin(input).output().unwrap())
    };
    from(&scene("rail.json")).quiet().prints("A car on a rail");
    from(&wrong.to_string_lossy()).exits(1).says("standard input: elements.s.mu").says("standard input: 3 faults\n");
}

#[test]
fn a_plan_evaluates_nothing() {
    let ran = Bench::new().run(&["scene", &scene("rail.json"), "--plan"]).quiet();
    assert!(
        ran.stdout.lines().all(|line| line.contains('×') || line.ends_with("evaluations over 2 states")),
        "{ran:?}"
    );
    ran.prints("slot.contact_force").prints("output FN").prints("at the start");
}

#[test]
fn plots_are_drawings_of_every_output() {
    let bench = Bench::new();
    let folder = bench.path("plots");
    bench.run(&["scene", &scene("telescope.json"), "--plot", &folder.to_string_lossy()]).exits(0).says("wrote");
    let svg = fs::read_to_string(folder.join("telescope.CSF1.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("<title") && !svg.contains("NaN"), "{svg}");
    let plot = ["scene", &scene("rail.json"), "--format", "csv", "--plot", &folder.to_string_lossy()];
    bench.run(&plot).exits(0).says("wrote").prints("time,element,output,component,value");
    assert!(folder.join("rail.CSF1.svg").exists());
}

#[test]
fn a_generated_scene_runs() {
    let bench = Bench::new();
    let file = bench.path("many.json");
    let generated = bench.run(&["scene", "--generate", "100"]).quiet();
    fs::write(&file, generated.stdout).unwrap();
    let ran = bench.run(&["scene", &file.to_string_lossy(), "--format", "csv"]).quiet();
    assert_eq!(ran.stdout.lines().count(), 1 + 100 * 5 * 5);
    // A table shows the first elements; other formats show all.
    let text = bench.run(&["scene", &file.to_string_lossy()]).quiet().prints("… and 92 more elements").stdout;
    let headings = text.lines().find(|line| line.trim_start().starts_with("time")).unwrap();
    assert_eq!(headings.split_whitespace().count(), 1 + 8, "{headings}");
    let json = bench.run(&["scene", &file.to_string_lossy(), "--format", "json"]).quiet().stdout;
    let results: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(results["series"].as_array().unwrap().len(), 100 * 5);
}

/// A generated scene and its description with arrays: only the names of the members differ.
#[test]
fn a_scene_of_arrays_gives_the_same_numbers() {
    let bench = Bench::new();
    let [json, described, arrays] = ["many.json", "described.json", "many.npz"].map(|name| bench.path(name));
    let arrays = arrays.to_string_lossy();
    let generate = |more: &[&str]| {
        let all = [&["scene", "--generate", "100", "--of", "translator", "--states", "3"], more].concat();
        bench.run(&all).quiet().stdout
    };
    fs::write(&json, generate(&[])).unwrap();
    fs::write(&described, generate(&["--columns", &arrays])).unwrap();
    let results = |path: &std::path::Path| {
        let csv = bench.run(&["scene", &path.to_string_lossy(), "--format", "csv"]).quiet().stdout;
        csv.replace(['[', ']'], "")
    };
    assert_eq!(results(&described).lines().count(), 1 + 100 * 3 * 8);
    assert_eq!(results(&json), results(&described));
}

#[test]
fn results_are_written_by_the_name_of_their_file() {
    let bench = Bench::new();
    let rail = scene("rail.json");
    let written = |name: &str| {
        let path = bench.path(name);
        let ran = bench.run(&["scene", &rail, "--out", &path.to_string_lossy()]).quiet();
        assert_eq!(ran.stdout, "");
        fs::read(path).unwrap()
    };
    let printed = |format: &str| bench.run(&["scene", &rail, "--format", format]).quiet().stdout.into_bytes();
    assert_eq!(written("results.csv"), printed("csv"));
    assert_eq!(written("results.json"), printed("json").trim_ascii_end());
    let arrays = written("results.npz");
    assert_eq!(arrays, written("again.NPZ"));
    assert!(arrays.starts_with(b"PK") && arrays.windows(14).any(|name| name == b"guide/CSF1.npy"));
    bench.run(&["scene", &rail, "--out", "results.xls"]).exits(2).says("one of .npz, .json, .csv, .txt");
    bench.run(&["scene", &rail, &rail, "--out", "results.npz"]).bad_usage("the results of one scene");
    for more in [&["--error"][..], &["--plot", "plots"]] {
        let asked = [&["scene", &rail, "--out", "results.npz"], more].concat();
        bench.run(&asked).bad_usage("arrays are written without --error and --plot");
    }
    // If something is wrong, nothing is written.
    let wrong = bench.path("wrong.json");
    fs::write(&wrong, WRONG).unwrap();
    let out = bench.path("none.npz");
    bench.run(&["scene", &wrong.to_string_lossy(), "--out", &out.to_string_lossy()]).exits(1);
    assert!(!out.exists());
}

/// A mutation of a scene.
type Mutation = fn(&mut Value);

#[test]
fn the_schema_takes_every_scene_and_refuses_what_the_reader_refuses() {
    let read = |path: &str| -> Value { serde_json::from_str(&fs::read_to_string(scene(path)).unwrap()).unwrap() };
    let schema = read("schema.json");
    jsonschema::meta::validate(&schema).unwrap_or_else(|error| panic!("{}: {error}", error.instance_path()));
    assert_eq!(schema, jointproof::scene::schema());
    let validator = jsonschema::draft202012::new(&schema).unwrap();
    let scenes = fs::read_dir(repository().join("golden/scenes")).unwrap().map(|entry| entry.unwrap().file_name());
    for name in scenes.map(|name| name.into_string().unwrap()).filter(|name| name.matches('.').count() == 1) {
        if name != "schema.json" {
            let faults: Vec<_> = validator.iter_errors(&read(&name)).map(|error| error.to_string()).collect();
            assert_eq!(faults, [""; 0], "{name}");
        }
    }
    let telescope: Value = serde_json::from_str(&fs::read_to_string(repository().join(TELESCOPE)).unwrap()).unwrap();
    let mutations: [(&str, Mutation); 9] = [
        ("an unknown key", |scene| scene["colour"] = json!("red")),
        ("another dimension", |scene| scene["dimension"] = json!("4d")),
        ("an unknown kind", |scene| scene["elements"]["telescope"]["kind"] = json!("slott")),
        ("an unknown parameter", |scene| scene["elements"]["telescope"]["mew"] = json!(1)),
        ("a parameter out of its domain", |scene| scene["elements"]["telescope"]["mu"] = json!(-1)),
        ("a coordinate too few", |scene| scene["nodes"]["inner"]["at"] = json!([0, 0])),
        ("text for a number", |scene| scene["frames"][0]["time"] = json!("NaN")),
        ("an unknown output", |scene| scene["outputs"] = json!(["U9"])),
        ("two descriptions of a triad", |scene| scene["orientations"]["tube"]["rotation"] = json!([0, 0, 1])),
    ];
    for (what, mutate) in mutations {
        let mut wrong = telescope.clone();
        mutate(&mut wrong);
        assert!(!validator.is_valid(&wrong), "{what} is accepted by the schema");
        let text = serde_json::to_string(&wrong).unwrap();
        assert!(jointproof::scene::Scene::parse(&text).is_err(), "{what} is accepted by the reader");
    }
    // Names of arrays are allowed only if the scene names a file of arrays.
    let named: [(&str, Mutation); 3] = [
        ("a node", |scene| scene["nodes"]["inner"]["at"] = json!("inner")),
        ("a parameter", |scene| scene["elements"]["telescope"]["mu"] = json!("mu")),
        ("a history", |scene| scene["frames"] = json!({ "time": "time", "nodes": { "inner": { "u": "u" } } })),
    ];
    for (what, name) in named {
        let mut scene = telescope.clone();
        name(&mut scene);
        assert!(!validator.is_valid(&scene), "{what} as the name of an array of no file is accepted");
        scene["columns"] = json!("arrays.npz");
        assert!(validator.is_valid(&scene), "{what} as the name of an array is not accepted");
    }
}

/// The deck of the book.
fn gate() -> String {
    repository().join("golden/decks/gate.inp").to_string_lossy().into_owned()
}

#[test]
fn a_deck_is_a_scene_that_can_be_written_and_says_what_is_left_out() {
    let bench = Bench::new();
    let written = bench.path("gate.json");
    let ran = bench.run(&["scene", &gate(), "--write", &written.to_string_lossy()]).exits(0);
    assert_eq!(ran.says("gate.inp: *CONNECTOR DAMPING (line 47): ").stdout, "");
    let committed = fs::read_to_string(repository().join("golden/decks/gate.json")).unwrap();
    assert_eq!(fs::read_to_string(&written).unwrap(), committed);
    let results = |path: &str| bench.run(&["scene", path, "--format", "csv"]).exits(0).stdout;
    assert_eq!(results(&gate()), results(&written.to_string_lossy()));
    bench
        .run(&["scene", &gate(), "--format", "csv", "--deny-warnings"])
        .exits(1)
        .says("left out: *MATERIAL (line 49): not read");
    bench.run(&["scene", &gate(), "--describe", "--deny-warnings"]).exits(1).says("*CONNECTOR DAMPING (line 47)");
    bench.run(&["scene", &scene("rail.json"), "--write", "x.json"]).bad_usage("--write takes the scene of one deck");
}

/// Every row of the scene's results is one of the deck's, which has more outputs.
#[test]
fn a_deck_has_its_history_from_tables() {
    let bench = Bench::new();
    let [deck, nodes, loads] = ["telescope.inp", "telescope.csv", "telescope-loads.csv"]
        .map(|name| repository().join("golden/decks").join(name).to_string_lossy().into_owned());
    let ran = bench.run(&["scene", &deck, "--history", &nodes, "--loads", &loads, "--format", "csv"]).exits(0);
    let found: std::collections::HashSet<&str> = ran.stdout.lines().collect();
    let expected = bench.run(&["scene", &scene("telescope.json"), "--format", "csv"]).exits(0).stdout;
    let expected = expected.replace(",telescope,", ",1,");
    assert!(expected.lines().count() > 9 * 14);
    expected.lines().for_each(|row| assert!(found.contains(row), "{row}"));
}

#[test]
fn a_wrong_deck_is_refused_with_its_lines_and_nothing_is_written() {
    let bench = Bench::new();
    let [deck, written] = ["wrong.inp", "wrong.json"].map(|name| bench.path(name));
    fs::write(&deck, "*NODE\n1, 0, 0, 0\n2, 0, x, 0\n*INCLUDE, INPUT=more.inc\n").unwrap();
    fs::write(bench.path("more.inc"), "*ELEMENT, TYPE=CONN3D2\n1, 1, y\n").unwrap();
    let ran = bench.run(&["scene", &deck.to_string_lossy(), "--write", &written.to_string_lossy()]).exits(1);
    ran.says("wrong.inp: *NODE (line 3, column 7): \"x\"; allowed is a number\n")
        .says("wrong.inp: *ELEMENT in more.inc (line 2, column 7): \"y\"; allowed is the number of a node, or instance.number\n")
        .says("wrong.inp: 2 faults\n");
    assert!(!written.exists());
}

#[test]
fn what_is_in_a_scene_is_described_as_text_and_as_a_page() {
    let bench = Bench::new();
    let ran = bench.run(&["scene", &gate(), "--describe"]).exits(0);
    ran.prints("3d, 2 elements: 1 hinge, 1 slot").prints("Post.1 at (0, 0, 0), e1 (0, 0, 1)").prints("Z           ");
    let page = bench.path("gate.html");
    bench.run(&["scene", &gate(), "--describe", "--out", &page.to_string_lossy()]).exits(0);
    let page = fs::read_to_string(page).unwrap();
    assert_eq!(page.matches("<svg").count(), 2);
    assert!(page.ends_with("</html>\n") && !page.contains("NaN") && !page.contains("inf"), "{page}");
    // Undefined at the start: said, and the others are described.
    let scene = bench.path("near.json");
    let text = r#"{"dimension": "3d", "orientations": {"o": {"rotation": [0, 0, 0]}, "p": {"rotation": [0, -1.5707963267948966, 0]}},
        "nodes": {"a": {"at": [0, 0, 0], "orientation": "o"}, "b": {"at": [1, 0, 0], "orientation": "p"}, "c": {"at": [3, 0, 0]}},
        "elements": {"gimbal": {"kind": "align", "nodes": ["a", "b"]}, "slot": {"kind": "slot", "nodes": ["a", "c"]}},
        "outputs": ["U1"]}"#;
    fs::write(&scene, text).unwrap();
    let ran = bench.run(&["scene", &scene.to_string_lossy(), "--describe"]).exits(0);
    ran.prints("undefined at the start: 1").prints("undefined   element \"gimbal\"").prints("X           3");
    bench.run(&["scene", &scene.to_string_lossy(), "--out", "page.html"]).bad_usage("--describe writes a page");
    bench
        .run(&["scene", &scene.to_string_lossy(), "--describe", "--out", "x.csv"])
        .bad_usage("--describe writes a page");
}
