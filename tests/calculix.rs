//! SLIDER compared with CalculiX, whose `*MPC STRAIGHT` holds a node on the line through two others, and which solves our linear
//! equations.
//!
//! Models of three nodes and three springs: the motions of nodes 1 and n are prescribed, and so is one coordinate of m; the
//! program finds the other two. It keeps the axis of the largest component of the undeformed line ([`Pivots::largest`]), whatever
//! the line becomes, and iterates until m is on the deformed line.
//!
//! Without `ccx` (Debian package `calculix-ccx`) the tests are skipped, unless `JOINTPROOF_REQUIRE_CCX` is set, as in .ci/run.
//! The agreement is recorded in `tests/data/foreign/calculix.json`, which the book shows; to update it:
//!
//! ```sh
//! cargo test --test all calculix:: -- --ignored
//! ```

use jointproof::connector::slider::{Increment, KeptIncrement, Pivots, Slider};
use jointproof::formula::value;
use nalgebra::Vector3;
use serde_json::{Value, json};
use std::fmt::Write;
use std::process::{Command, Stdio};

/// A line with m on it, the motions of nodes 1 and n, and that of m along the kept axis.
#[derive(Clone, Copy, Debug)]
struct Model {
    name: &'static str,
    x1: [f64; 3],
    xn: [f64; 3],
    xm: [f64; 3],
    u1: [f64; 3],
    un: [f64; 3],
    umk: f64,
}

const MODELS: [Model; 6] = [
    Model {
        name: "generic",
        x1: [1.0, 2.0, 3.0],
        xn: [3.0, 2.5, 3.75],
        xm: [1.5, 2.125, 3.1875],
        u1: [0.1, -0.2, 0.3],
        un: [0.2, 1.0, -0.5],
        umk: 0.7,
    },
    Model {
        name: "along-x",
        x1: [1.0, 2.0, 3.0],
        xn: [3.0, 2.0, 3.0],
        xm: [1.5, 2.0, 3.0],
        u1: [0.1, -0.2, 0.3],
        un: [0.2, 1.0, -0.5],
        umk: 0.7,
    },
    Model {
        name: "stays-along-x",
        x1: [1.0, 0.0, 0.0],
        xn: [3.0, 0.0, 0.0],
        xm: [1.5, 0.0, 0.0],
        u1: [0.1, 0.0, 0.0],
        un: [0.2, 1e-7, -2e-7],
        umk: 0.7,
    },
    Model {
        name: "in-the-plane",
        x1: [1.0, 2.0, 0.0],
        xn: [2.0, 4.5, 0.0],
        xm: [1.5, 3.25, 0.0],
        u1: [0.1, -0.2, 0.0],
        un: [0.2, 1.0, 0.0],
        umk: 0.7,
    },
    Model {
        name: "extremal-pivot",
        x1: [0.0, 0.0, 0.0],
        xn: [2.0, 1.0, 1.0],
        xm: [1.0, 0.5, 0.5],
        u1: [0.1, -0.2, 0.1],
        un: [0.2, 0.1, -0.3],
        umk: 0.25,
    },
    Model {
        name: "m-outside",
        x1: [1.0, 2.0, 3.0],
        xn: [1.25, 1.0, 5.0],
        xm: [2.0, -2.0, 11.0],
        u1: [0.1, -0.2, 0.3],
        un: [0.2, 0.1, -0.5],
        umk: 0.7,
    },
];

impl Model {
    /// The axis that CalculiX keeps.
    fn kept(&self) -> usize {
        Pivots::largest(&Vector3::from(self.x1), &Vector3::from(self.xn)).k
    }

    /// The same motions, so small that only their first order matters.
    fn scaled(&self, factor: f64) -> Self {
        let [u1, un] = [self.u1, self.un].map(|u| u.map(|x| x * factor));
        Self { u1, un, umk: self.umk * factor, ..*self }
    }

    /// The model with `*MPC STRAIGHT`, on the deformed line.
    fn by_mpc(&self) -> String {
        self.input("*MPC\nSTRAIGHT, 1, 2, 3\n*STEP, NLGEOM, INC=1000\n*STATIC\n1., 1.", self.kept())
    }

    /// The model with our two linear equations, on the undeformed line.
    fn by_equations(&self) -> String {
        let [x1, xn, xm] = [self.x1, self.xn, self.xm].map(Vector3::from);
        let slider = Slider::new(x1, xn).unwrap();
        let [first, second] = slider.equations(xm).unwrap().map(|equation| equation.card([1, 2, 3]).to_string());
        self.input(&format!("{first}{second}*STEP\n*STATIC"), slider.pivots().k)
    }

    /// The input; CalculiX reads 20 characters per number.
    fn input(&self, held: &str, kept: usize) -> String {
        let mut input = String::from("*NODE, NSET=ALL\n");
        let mut line = |text: std::fmt::Arguments<'_>| {
            let _ = writeln!(input, "{text}");
        };
        for (node, [x, y, z]) in (1..).zip([self.x1, self.xn, self.xm]) {
            line(format_args!("{node}, {x:.12e}, {y:.12e}, {z:.12e}"));
        }
        for axis in 1..=3 {
            line(format_args!("*ELEMENT, TYPE=SPRING1, ELSET=E{axis}\n{axis}, 3\n*SPRING, ELSET=E{axis}\n{axis}\n1."));
        }
        line(format_args!("{held}\n*BOUNDARY"));
        for (node, motion) in (1..).zip([self.u1, self.un]) {
            for (axis, u) in (1..).zip(motion) {
                line(format_args!("{node}, {axis}, {axis}, {u:.12e}"));
            }
        }
        let axis = kept + 1;
        line(format_args!("3, {axis}, {axis}, {:.12e}", self.umk));
        line(format_args!("*NODE PRINT, NSET=ALL, FREQUENCY=1000\nU\n*END STEP"));
        input
    }

    /// The displacement of m that CalculiX prints for an input, and half a unit in the last digit of each component.
    fn run(&self, input: String) -> (Vector3<f64>, Vector3<f64>) {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("model.inp"), input).unwrap();
        let run = Command::new("ccx").arg("model").current_dir(folder.path()).stdin(Stdio::null()).output().unwrap();
        let log = String::from_utf8_lossy(&run.stdout);
        assert!(run.status.success() && !log.contains("*ERROR"), "{}: {log}", self.name);
        let printed = std::fs::read_to_string(folder.path().join("model.dat")).unwrap();
        let of_m = printed.lines().filter_map(|line| line.trim_start().strip_prefix("3 ")).next_back();
        let numbers: Vec<_> = of_m.unwrap_or_else(|| panic!("no node 3 in {printed}")).split_whitespace().collect();
        let value = |axis: usize| numbers[axis].parse::<f64>().unwrap();
        // 1.234567E-01: six digits after the point.
        let half_unit = |axis: usize| {
            let (mantissa, exponent) = numbers[axis].split_once('E').unwrap();
            assert_eq!(mantissa.trim_start_matches('-').len(), 8, "{printed}");
            format!("0.5e{}", exponent.parse::<i32>().unwrap() - 6).parse().unwrap()
        };
        (Vector3::from_fn(|axis, _| value(axis)), Vector3::from_fn(|axis, _| half_unit(axis)))
    }
}

/// Whether `ccx` is available.
fn calculix() -> bool {
    let found = Command::new("ccx").arg("-v").stdout(Stdio::null()).stderr(Stdio::null()).stdin(Stdio::null()).status();
    if found.is_ok() {
        return true;
    }
    assert!(
        std::env::var_os("JOINTPROOF_REQUIRE_CCX").is_none(),
        "JOINTPROOF_REQUIRE_CCX is set, but ccx is not found: apt-get install calculix-ccx"
    );
    eprintln!("skipped: ccx is not found; apt-get install calculix-ccx to compare SLIDER with CalculiX");
    false
}

/// A number from CalculiX, ours, and their allowed difference.
struct Pair {
    model: &'static str,
    axis: usize,
    theirs: f64,
    ours: f64,
    allowed: f64,
    /// The largest component of the displacement of m.
    size: f64,
}

/// The worst error of all, relative to the displacement of m.
fn worst(pairs: &[Pair]) -> f64 {
    let error = |Pair { model, axis, theirs, ours, allowed, size }: &Pair| {
        let error = (ours - theirs).abs();
        assert!(error <= *allowed, "{model}, axis {axis}: {ours} {theirs} ± {allowed:e}");
        error / size
    };
    pairs.iter().map(error).fold(0.0, f64::max)
}

/// The position of m from `*MPC STRAIGHT`, and that from the elimination.
fn placed() -> Vec<Pair> {
    let mut pairs = Vec::new();
    for model in MODELS {
        let (u, half_unit) = model.run(model.by_mpc());
        let [x1, xn, xm] = [model.x1, model.xn, model.xm].map(Vector3::from);
        let slider = Slider::new(x1 + Vector3::from(model.u1), xn + Vector3::from(model.un)).unwrap();
        let ours = Pivots::new(&(x1 + Vector3::from(model.u1)), &(xn + Vector3::from(model.un)));
        let (k, mut kept) = (model.kept(), xm + u);
        kept[k] = xm[k] + model.umk; // the prescribed value, not the printed one
        if ours.k != k {
            // The deformed line has another kept axis: that coordinate of m is known only to the printed digits.
            assert_eq!(model.name, "extremal-pivot");
        }
        let placed = slider.place(kept).unwrap();
        // Half a unit in the last digit of the kept coordinate amounts to up to |n_axis/n_k| ≤ √5 of it.
        let slack = if ours.k == k { 0.0 } else { 5.0_f64.sqrt() * half_unit[ours.k] };
        pairs.extend((0..3).map(|axis| Pair {
            model: model.name,
            axis,
            theirs: kept[axis],
            ours: placed[axis],
            allowed: half_unit[axis] + slack + 1e-14,
            size: u.amax(),
        }));
    }
    pairs
}

/// Small motions with `*MPC STRAIGHT`, and the eliminated increments.
fn increments() -> Vec<Pair> {
    let mut pairs = Vec::new();
    for model in MODELS.map(|model| model.scaled(1e-6)) {
        let (u, half_unit) = model.run(model.by_mpc());
        let [x1, xn, xm, dx1, dxn] = [model.x1, model.xn, model.xm, model.u1, model.un].map(Vector3::from);
        let Pivots { i, j, k } = Pivots::new(&x1, &xn);
        if k != model.kept() {
            assert_eq!(model.name, "extremal-pivot");
            continue; // The rules keep different axes, so that different numbers are given.
        }
        let expected = value::<Increment>(&KeptIncrement { x1, xn, xm, dx1, dxn, dxmk: model.umk }).unwrap();
        // The difference is of second order in the motion: |dx|²/l, times the distance of m along the line.
        let size = dx1.amax().max(dxn.amax()).max(model.umk.abs());
        let second_order = 4.0 * size * size * (1.0 + (xm - x1).norm() / (xn - x1).norm());
        pairs.extend([(i, expected.dxmi), (j, expected.dxmj)].map(|(axis, ours)| Pair {
            model: model.name,
            axis,
            theirs: u[axis],
            ours,
            allowed: half_unit[axis] + second_order,
            size: u.amax(),
        }));
    }
    pairs
}

/// The results of CalculiX with our equations, and our increments.
fn solved() -> Vec<Pair> {
    let mut pairs = Vec::new();
    for model in MODELS {
        let (u, half_unit) = model.run(model.by_equations());
        let [x1, xn, xm, dx1, dxn] = [model.x1, model.xn, model.xm, model.u1, model.un].map(Vector3::from);
        let expected = Slider::new(x1, xn).unwrap().increment(xm, dx1, dxn, model.umk).unwrap();
        // Half a unit in the 13th digit of six coefficients.
        let rounding = 6.0 * 0.5e-12 * (dx1.amax() + dxn.amax() + model.umk) * (xm - x1).norm().max(1.0);
        pairs.extend((0..3).map(|axis| Pair {
            model: model.name,
            axis,
            theirs: u[axis],
            ours: expected[axis],
            allowed: half_unit[axis] + rounding,
            size: u.amax(),
        }));
    }
    pairs
}

/// A comparison, with its name in the book.
type Compared = (&'static str, fn() -> Vec<Pair>);

const COMPARED: [Compared; 3] =
    [("place of node m", placed), ("increments of node m", increments), ("linear equations, solved there", solved)];

const RECORD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/foreign/calculix.json");

#[test]
fn calculix_agrees_no_worse_than_the_book_says() {
    if !calculix() {
        return;
    }
    let record: Value = serde_json::from_str(&std::fs::read_to_string(RECORD).unwrap()).unwrap();
    let recorded = record["comparisons"].as_array().unwrap();
    assert_eq!(recorded.len(), COMPARED.len());
    for (said, (quantity, compared)) in recorded.iter().zip(COMPARED) {
        assert_eq!(said["quantity"], quantity);
        let (error, said) = (worst(&compared()), said["worst"].as_f64().unwrap());
        // If all printed digits agree, the difference is due to rounding, and depends on the processor.
        let allowed = f64::max(4.0 * said, 4.0 * f64::EPSILON);
        assert!(error <= allowed, "{quantity}: {error:e}, the book says {said:e}");
    }
}

/// The compared numbers would not agree with the opposite sign, unless they are zero to the printed digits.
#[test]
fn a_wrong_sign_is_found() {
    if !calculix() {
        return;
    }
    for (quantity, compared) in COMPARED {
        let pairs = compared();
        let signed = pairs.iter().filter(|pair| pair.theirs.abs() > pair.allowed);
        assert!(2 * signed.clone().count() > pairs.len(), "{quantity}: most are zero");
        for Pair { model, axis, theirs, ours, allowed, .. } in signed {
            assert!((-ours - theirs).abs() > *allowed, "{quantity}, {model}, axis {axis}: {ours} {theirs}");
        }
    }
}

#[test]
#[ignore = "it writes tests/data/foreign/calculix.json"]
fn write_how_well_calculix_agrees() {
    let version = Command::new("ccx").arg("-v").output().unwrap();
    let version = String::from_utf8(version.stdout).unwrap();
    let version = version.split_whitespace().next_back().unwrap();
    let lines = COMPARED.map(|(quantity, compared)| {
        let pairs = compared();
        let models = pairs.chunk_by(|a, b| a.model == b.model).count();
        let worst: f64 = format!("{:.1e}", worst(&pairs)).parse().unwrap();
        let places = format!("{models} models");
        format!("    {}", json!({ "connector": "SLIDER", "quantity": quantity, "places": places, "worst": worst }))
    });
    let text = format!(
        "{{\n  \"program\": \"CalculiX\", \"version\": \"{version}\",\n  \"comparisons\": [\n{}\n  ]\n}}\n",
        lines.join(",\n")
    );
    std::fs::write(RECORD, text).unwrap();
}
