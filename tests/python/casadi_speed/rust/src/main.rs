//! Nanoseconds that a step of Newton's method takes of every element, as a user calls it, at the points of `<element>_<form>.f64`
//! in the folder that is given.

use jointproof::connector::align::AlignElement;
use jointproof::connector::hinge::HingeElement;
use jointproof::connector::join::JoinElement;
use jointproof::connector::slider::{SliderElement, SliderElement2d};
use jointproof::connector::slot::{SlotElement, SlotElement2d};
use jointproof::connector::translator::TranslatorElement;
use jointproof::connector::ujoint::UJointElement;
use jointproof::connector::universal::UniversalElement;
use jointproof::contact::interaction::{PressureExponential, PressureLinear};
use jointproof::contact::slide_line::element::{Isl21aElement, Isl22aElement};
use jointproof::formula::Fields;
use jointproof::formula::element::{Element, Parameters};
use nalgebra::SVector;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// What a turn takes at least, and the number of turns, of which the median counts.
const TURN: u128 = 1_000_000;
const TURNS: usize = 15;

fn read(path: &Path) -> Option<Vec<f64>> {
    Some(std::fs::read(path).ok()?.as_chunks::<8>().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect())
}

/// The next fields of a point.
fn taken<X: Fields<f64>>(x: &mut impl Iterator<Item = f64>) -> X {
    X::from_components(&mut || x.next().expect("a point has all components"))
}

fn time<E: Element<M, DOFS>, const M: usize, const DOFS: usize>(folder: &Path) {
    let id = E::SPEC.id;
    for (form, rubs) in [("smooth", false), ("rubbing", true)] {
        let Some(numbers) = read(&folder.join(format!("{id}_{form}.f64"))) else { continue };
        let held = E::MULTIPLIERS.len();
        let fixed = E::Nodes::<f64>::LEN + held + E::Start::<f64>::LEN;
        let length = fixed + if rubs { E::Contact::<f64>::LEN + E::State::<f64>::LEN } else { 0 };
        let point = |point: &[f64]| {
            let mut x = point.iter().copied();
            let nodes: E::Nodes<f64> = taken(&mut x);
            let multipliers = SVector::<f64, M>::from_fn(|k, _| if k < held { x.next().expect("as many") } else { 0.0 });
            let start: E::Start<f64> = taken(&mut x);
            let contact: Option<E::Contact<f64>> = rubs.then(|| taken(&mut x));
            let before: E::State<f64> = if rubs { taken(&mut x) } else { Fields::filled(0.0) };
            (nodes, multipliers, Parameters::<E, f64, M, DOFS> { start, contact }, before)
        };
        let points: Vec<_> = numbers.chunks(length).map(point).collect();
        let pass = || {
            for (nodes, multipliers, parameters, before) in black_box(&points) {
                black_box(&parameters.newton(nodes, multipliers, before)).as_ref().expect("the points are valid");
            }
        };
        let mut times: Vec<f64> = (0..TURNS).map(|_| turn(&pass) / points.len() as f64).collect();
        times.sort_by(f64::total_cmp);
        println!("{id}_{form} {}", times[TURNS / 2]);
    }
}

/// Nanoseconds of a pass.
fn turn(pass: &impl Fn()) -> f64 {
    let (start, mut passes) = (Instant::now(), 0.0);
    loop {
        pass();
        passes += 1.0;
        let time = start.elapsed().as_nanos();
        if time >= TURN {
            return time as f64 / passes;
        }
    }
}

fn main() {
    let folder = std::env::args().nth(1).expect("the folder of the points is given");
    let folder = Path::new(&folder);
    time::<SlotElement, 2, 12>(folder);
    time::<SlotElement2d, 1, 6>(folder);
    time::<AlignElement, 3, 12>(folder);
    time::<TranslatorElement, 5, 12>(folder);
    time::<JoinElement, 3, 12>(folder);
    time::<UniversalElement, 1, 12>(folder);
    time::<UJointElement, 4, 12>(folder);
    time::<HingeElement, 5, 12>(folder);
    time::<SliderElement, 2, 9>(folder);
    time::<SliderElement2d, 1, 6>(folder);
    time::<Isl21aElement<PressureLinear>, 1, 12>(folder);
    time::<Isl21aElement<PressureExponential>, 1, 12>(folder);
    time::<Isl22aElement<PressureLinear>, 1, 24>(folder);
    time::<Isl22aElement<PressureExponential>, 1, 24>(folder);
}
